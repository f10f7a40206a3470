// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowState.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysShadowFaces.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkHyperTreeGrid.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
/// Adds what a prop's depths and translucent layers depend on: objects, and when they were modified.
struct PropState
{
  std::vector<const void*>& Objects;
  std::vector<double>& Numbers;
  double UpdateRate; // of the window

  /// Makes the prop differ from itself in the next frame, as NaN does: VTK cannot tell whether it changes.
  void AddUnknown() { this->Numbers.push_back(std::numeric_limits<double>::quiet_NaN()); }

  void Add(vtkObject* object)
  {
    this->Objects.push_back(object);
    this->Numbers.push_back(object ? static_cast<double>(object->GetMTime()) : 0.0);
  }

  /// A composite data set does not have the times of its blocks. The surface of a tree grid may depend on the
  /// camera.
  void AddData(vtkDataObject* data)
  {
    this->Add(data);
    if (!data || vtkHyperTreeGrid::SafeDownCast(data))
    {
      this->AddUnknown();
    }
    else if (auto composite = vtkCompositeDataSet::SafeDownCast(data))
    {
      const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
      {
        this->Numbers.push_back(blocks->GetCurrentFlatIndex());
        this->AddData(blocks->GetCurrentDataObject());
      }
    }
  }

  /// Adds a mapper or a texture with its inputs. The scene has been drawn, so that inputs are up to date, but
  /// not those of what the camera does not see: they are updated as VTK does before it draws.
  void AddInputs(vtkAlgorithm* algorithm, bool isStatic = false)
  {
    this->Add(algorithm);
    if (algorithm->GetTotalNumberOfInputConnections() == 0)
    {
      this->AddUnknown(); // it has its data from elsewhere
    }
    for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
    {
      for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
      {
        if (!isStatic)
        {
          algorithm->GetInputAlgorithm(port, i)->Update();
        }
        this->AddData(algorithm->GetInputDataObject(port, i));
      }
    }
  }

  void AddTexture(vtkTexture* texture)
  {
    if (texture)
    {
      this->AddInputs(texture);
      this->Add(texture->GetLookupTable());
      this->Add(texture->GetTransform());
    }
  }

  void AddProperty(vtkProperty* property)
  {
    this->Add(property);
    if (property)
    {
      for (const auto& texture : property->GetAllTextures())
      {
        this->AddTexture(texture.second);
      }
    }
  }

  void AddShader(vtkShaderProperty* shader)
  {
    this->Add(shader);
    this->Numbers.push_back(static_cast<double>(shader->GetShaderMTime()));
    this->Add(shader->GetVertexCustomUniforms());
    this->Add(shader->GetGeometryCustomUniforms());
    this->Add(shader->GetFragmentCustomUniforms());
  }

  void AddMapper(vtkMapper* mapper)
  {
    this->AddInputs(mapper, mapper->GetStatic() != 0);
    vtkPlaneCollection* planes = mapper->GetClippingPlanes();
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      this->Add(planes->GetItem(i)); // the mapper's time does not tell of planes' changes
    }
    if (auto glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
    {
      this->Add(glyphs->GetBlockAttributes()); // nor of these
    }
    if (mapper->HasObserver(vtkCommand::UpdateShaderEvent))
    {
      this->AddUnknown(); // it may give shaders other numbers at each draw
    }
  }

  /// An actor of another class than VTK's own may draw a coarser mapper when it has less time than its
  /// mapper takes, as vtkLODActor does, or than the update rate allows, as vtkQuadricLODActor does.
  /// ParaView's actor returns the mapper that it draws. An actor without a mapper draws by other means. A
  /// follower's matrix turns with its camera.
  void AddActor(vtkActor* actor, vtkMatrix4x4* matrix, bool isPart)
  {
    vtkMapper* mapper = actor->GetMapper();
    if (!mapper || !matrix)
    {
      this->AddUnknown();
      return;
    }
    if (std::strcmp(actor->GetClassName(), "vtkOpenGLActor") != 0)
    {
      this->Numbers.push_back(this->UpdateRate);
      if (isPart || mapper->GetTimeToDraw() > actor->GetAllocatedRenderTime())
      {
        this->AddUnknown();
      }
    }
    this->Numbers.insert(this->Numbers.end(), matrix->GetData(), matrix->GetData() + 16);
    this->Numbers.push_back(actor->GetForceOpaque() + 2.0 * actor->GetForceTranslucent());
    this->AddProperty(actor->GetProperty());
    this->AddProperty(actor->GetBackfaceProperty());
    this->AddTexture(actor->GetTexture());
    this->AddShader(actor->GetShaderProperty());
    this->AddMapper(mapper);
    if (!isPart)
    {
      this->Numbers.push_back(static_cast<double>(actor->GetRedrawMTime()));
    }
  }

  /// A volume draws nothing into a map by itself. An assembly modifies its parts whenever it draws them, so
  /// that parts have no times of their own.
  void AddProp(vtkProp* prop, vtkMatrix4x4* matrix, bool isPart)
  {
    this->Objects.push_back(prop);
    if (auto actor = vtkActor::SafeDownCast(prop))
    {
      this->AddActor(actor, matrix, isPart);
    }
    else if (vtkAssembly::SafeDownCast(prop) || vtkPropAssembly::SafeDownCast(prop))
    {
      prop->InitPathTraversal();
      while (vtkAssemblyPath* path = prop->GetNextPath())
      {
        vtkAssemblyNode* part = path->GetLastNode();
        if (part->GetViewProp()->GetVisibility())
        {
          this->AddProp(part->GetViewProp(), part->GetMatrix(), true);
        }
      }
    }
    else if (!vtkVolume::SafeDownCast(prop))
    {
      this->AddUnknown();
    }
  }
};
}

// Left empty on several processes: the others would have to agree.
void vtkGodRaysShadowState::Find(const vtkGodRaysMediumIntegrator::Request& request,
  const vtkGodRaysShadowFaces& faces, const vtkGodRaysTarget& map)
{
  this->Clear();
  if (request.Compositor && request.Compositor->IsDistributed())
  {
    return;
  }
  this->Objects = { request.Window, request.Renderer, map.GetDepth() };
  this->Numbers = { faces.Size + 0.0, faces.Count + 0.0, map.GetOrigin()[0] + 0.0,
    map.GetOrigin()[1] + 0.0 };
  for (int face = 0; face < faces.Count; ++face)
  {
    for (const double* corner : faces.Corners)
    {
      const double view[4] = { corner[0], corner[1], corner[2], 1.0 };
      double place[4];
      vtkMatrix4x4::MultiplyPoint(faces.ViewToMap[face], view, place);
      this->Places.insert(this->Places.end(), place, place + 4);
    }
  }
  this->End();
  PropState state = { this->Objects, this->Numbers, request.Window->GetDesiredUpdateRate() };
  for (vtkProp* prop : *request.Occluders)
  {
    if (vtkVolume* volume = vtkGodRaysVolumeHaze::GetVolume(prop))
    {
      vtkGodRaysVolumeHaze::AddState(volume, this->Objects, this->Numbers);
    }
    else
    {
      state.AddProp(prop, prop->GetMatrix(), false);
    }
    this->End();
  }
}

void vtkGodRaysShadowState::Clear()
{
  this->Objects.clear();
  this->Numbers.clear();
  this->Places.clear();
  this->Ends.clear();
}

bool vtkGodRaysShadowState::IsSame(const vtkGodRaysShadowState& other) const
{
  return this->Objects == other.Objects && this->Numbers == other.Numbers &&
    this->HasSameFaces(other);
}

// And as many props.
bool vtkGodRaysShadowState::HasSameFaces(const vtkGodRaysShadowState& other) const
{
  if (this->Ends.empty() || this->Ends.size() != other.Ends.size() ||
    this->Ends[0] != other.Ends[0])
  {
    return false;
  }
  double largest = 0.0;
  for (const double place : this->Places)
  {
    largest = std::max(largest, std::abs(place));
  }
  return std::equal(this->Objects.begin(), this->Objects.begin() + this->Ends[0][0],
           other.Objects.begin()) &&
    std::equal(
      this->Numbers.begin(), this->Numbers.begin() + this->Ends[0][1], other.Numbers.begin()) &&
    std::equal(this->Places.begin(), this->Places.end(), other.Places.begin(), other.Places.end(),
      [=](double one, double two) { return std::abs(one - two) <= 1e-9 * largest; });
}

bool vtkGodRaysShadowState::HasSameProp(const vtkGodRaysShadowState& other, std::size_t prop) const
{
  const auto isSame = [&](const auto& own, const auto& others, int kind)
  {
    return std::equal(own.begin() + this->Ends[prop][kind],
      own.begin() + this->Ends[prop + 1][kind], others.begin() + other.Ends[prop][kind],
      others.begin() + other.Ends[prop + 1][kind]);
  };
  return isSame(this->Objects, other.Objects, 0) && isSame(this->Numbers, other.Numbers, 1);
}
