// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfImporter.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkGLTFDocumentLoader.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace
{
//------------------------------------------------------------------------------
using Material = vtkGLTFDocumentLoader::Material;

//------------------------------------------------------------------------------
/// Encodes linear light as screens show it: IEC 61966-2-1.
double Encode(double linear)
{
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

//------------------------------------------------------------------------------
bool IsOpaque(const Material* material)
{
  return !material ||
    (material->AlphaMode != Material::AlphaModeType::MASK &&
      material->AlphaMode != Material::AlphaModeType::BLEND);
}

//------------------------------------------------------------------------------
/// Gives vertices, if they have colours, those that are shown, which are times the factor of the material.
void EncodeColors(vtkPolyData* surface, const Material* material)
{
  vtkDataArray* linear = surface ? surface->GetPointData()->GetScalars() : nullptr;
  if (!linear || linear->GetNumberOfComponents() < 3)
  {
    return;
  }
  const int components = IsOpaque(material) ? 3 : linear->GetNumberOfComponents();
  auto shown = vtkSmartPointer<vtkUnsignedCharArray>::New();
  shown->SetName("Colors");
  shown->SetNumberOfComponents(components);
  shown->SetNumberOfTuples(linear->GetNumberOfTuples());
  for (vtkIdType i = 0; i < linear->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      double value = linear->GetComponent(i, c);
      if (c < 3)
      {
        value =
          Encode(value * (material ? material->PbrMetallicRoughness.BaseColorFactor[c] : 1.0));
      }
      shown->SetTypedComponent(
        i, c, static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
    }
  }
  surface->GetPointData()->SetScalars(shown);
}

//------------------------------------------------------------------------------
void ApplyMaterial(const Material& material, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  const auto& factor = material.PbrMetallicRoughness.BaseColorFactor;
  property->SetColor(Encode(factor[0]), Encode(factor[1]), Encode(factor[2]));
  const bool isMask = material.AlphaMode == Material::AlphaModeType::MASK;
  property->SetOpacity(isMask || IsOpaque(&material) ? 1.0 : factor[3]);
  actor->SetForceTranslucent(material.AlphaMode == Material::AlphaModeType::BLEND);
  actor->SetForceOpaque(!actor->GetForceTranslucent());
  vtkTexture* texture = property->GetTexture("albedoTex");
  const bool hasAlpha =
    texture && texture->GetInput() && texture->GetInput()->GetNumberOfScalarComponents() % 2 == 0;
  if (isMask || (IsOpaque(&material) && hasAlpha))
  {
    // The cut applies in each pass that draws the actor, those of shadows and rays, too.
    constexpr double least = 1e-6;
    const std::string cutoff =
      std::to_string(isMask ? material.AlphaCutoff / std::max(factor[3], least) : 0.0);
    actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::TCoord::Impl", true,
      "//VTK::TCoord::Impl\n  if (gl_FragData[0].a < " + cutoff +
        ")\n  {\n    discard;\n  }\n  gl_FragData[0].a = 1.0;\n",
      false);
  }
}
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(GltfImporter);

//------------------------------------------------------------------------------
void GltfImporter::ImportActors(vtkRenderer* renderer)
{
  this->Superclass::ImportActors(renderer);
  const auto model = this->Loader->GetInternalModel();
  if (!model)
  {
    return; // the reader has said why
  }
  const auto findMaterial = [&model](const vtkGLTFDocumentLoader::Primitive& primitive)
  {
    const auto index = static_cast<std::size_t>(primitive.Material); // that of -1 is beyond all
    return index < model->Materials.size() ? &model->Materials[index] : nullptr;
  };
  for (const auto& mesh : model->Meshes)
  {
    for (const auto& primitive : mesh.Primitives)
    {
      EncodeColors(primitive.Geometry, findMaterial(primitive));
    }
  }
  for (const auto& [node, actors] : this->Actors)
  {
    const auto& mesh = model->Meshes[static_cast<std::size_t>(model->Nodes[node].Mesh)];
    for (std::size_t i = 0; i < std::min(actors.size(), mesh.Primitives.size()); ++i)
    {
      if (const Material* material = findMaterial(mesh.Primitives[i]))
      {
        ApplyMaterial(*material, actors[i]);
      }
    }
  }
}
