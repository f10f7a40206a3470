// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysOcclusionPass: translucent props and volumes, which dim the light.

#include "GodRaysOcclusionTesting.h"

#include "vtkElevationFilter.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkSmartVolumeMapper.h"

using namespace GodRaysTesting;

class GodRaysOcclusionDimming : public GodRaysOcclusion
{
protected:
  double GetCentre() { return GetValue(this->GetLayer(), Width / 2, Height / 2); }
};

TEST_F(GodRaysOcclusionDimming, OpacityHalvesTheLightWithAndWithoutDepthPeeling)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  auto front = this->AddBox({ 0.0, 0.0, 1.0 }, { 4.0, 4.0, 0.0 });
  auto back = this->AddBox({ 0.0, 0.0, -1.0 }, { 4.0, 4.0, 0.0 });
  vtkNew<vtkPlaneSource> plane; // one face each
  front->GetMapper()->SetInputConnection(plane->GetOutputPort());
  back->GetMapper()->SetInputConnection(plane->GetOutputPort());
  front->SetScale(4.0);
  back->SetScale(4.0);
  back->SetPosition(0.0, 0.0, -2.0);
  for (bool peeling : { false, true })
  {
    SCOPED_TRACE(peeling);
    this->Renderer->SetUseDepthPeeling(peeling);
    this->Scene.Window->SetAlphaBitPlanes(true);
    back->VisibilityOff();
    front->GetProperty()->SetOpacity(1.0);
    EXPECT_EQ(this->GetCentre(), 0.0);
    front->GetProperty()->SetOpacity(0.5);
    EXPECT_NEAR(this->GetCentre(), 0.5, 1e-3);
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "opacity of 1 translucent")) << this->Rays->GetPlan();
    EXPECT_EQ(this->Rays->GetNumberOfGeometryPasses(), 1);
    back->VisibilityOn();
    back->GetProperty()->SetOpacity(0.5);
    EXPECT_NEAR(this->GetCentre(), 0.25, 1e-3);
    back->GetProperty()->SetOpacity(0.01); // faint ones count, too
    EXPECT_NEAR(this->GetCentre(), 0.495, 1e-3);
    vtkGodRaysPass::SetRole(front, vtkGodRaysPass::IGNORED);
    vtkGodRaysPass::SetRole(back, vtkGodRaysPass::IGNORED);
    EXPECT_EQ(this->GetCentre(), 1.0);
    vtkGodRaysPass::SetRole(front, vtkGodRaysPass::AUTOMATIC);
    vtkGodRaysPass::SetRole(back, vtkGodRaysPass::AUTOMATIC);
  }
}

TEST_F(GodRaysOcclusionDimming, ManyFaintPropsAddUp)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  vtkNew<vtkPlaneSource> plane;
  for (int i = 0; i < 50; ++i)
  {
    auto sheet = this->AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
    sheet->GetMapper()->SetInputConnection(plane->GetOutputPort());
    sheet->SetScale(4.0);
    sheet->SetPosition(0.0, 0.0, -0.05 * i);
    sheet->GetProperty()->SetOpacity(0.01);
  }
  EXPECT_NEAR(this->GetCentre(), std::pow(0.99, 50), 5e-3);
}

TEST_F(GodRaysOcclusionDimming, OpacityOfScalarsCounts)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  auto sheet = this->AddBox({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(plane->GetOutputPort());
  elevation->SetLowPoint(-1e6, 0.0, 0.0); // 0.5 all over
  elevation->SetHighPoint(1e6, 0.0, 0.0);
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(0.3, 0.3);
  table->Build();
  sheet->GetMapper()->SetInputConnection(elevation->GetOutputPort());
  sheet->GetMapper()->SetLookupTable(table);
  sheet->SetScale(4.0);
  EXPECT_NEAR(this->GetCentre(), 0.7, 3e-3); // the table has 8-bit entries
}

TEST_F(GodRaysOcclusionDimming, VolumesDimByTheirTransmittance)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  auto fog = MakeFog(mapper, { 0.0, 0.0, 0.0 }, 0.7);
  this->Renderer->AddVolume(fog);
  const double expected = 0.7 * 0.7; // 2 units thick
  const double found = this->GetCentre();
  std::cout << "volume: transmittance " << found << ", expected " << expected << "\n";
  EXPECT_NEAR(found, expected, 0.02);
  vtkGodRaysPass::SetRole(fog, vtkGodRaysPass::IGNORED);
  EXPECT_EQ(this->GetCentre(), 1.0);
  vtkGodRaysPass::SetRole(fog, vtkGodRaysPass::OCCLUDER);

  // opaque props hide it, and it hides nothing before it
  auto box = this->AddBox({ 0.0, 0.0, 3.0 }, { 1.0, 1.0, 1.0 });
  EXPECT_EQ(this->GetCentre(), 0.0);
  vtkGodRaysPass::SetRole(box, vtkGodRaysPass::IGNORED);
  EXPECT_NEAR(this->GetCentre(), found, 1e-3) << "an ignored prop before it changes nothing";
  this->Renderer->RemoveActor(box);

  // in a viewport that does not start at the origin
  this->Renderer->SetViewport(0.5, 0.25, 1.0, 0.75);
  vtkSmartPointer<vtkImageData> layer = this->GetLayer();
  EXPECT_EQ(layer->GetDimensions()[0], Width / 2);
  EXPECT_NEAR(GetValue(layer, Width / 4, Height / 4), found, 5e-3);
  this->Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);

  // coarser pictures of the mapper
  mapper->SetImageSampleDistance(2.0f);
  EXPECT_NEAR(this->GetCentre(), found, 0.02);
  mapper->SetImageSampleDistance(1.0f);
  EXPECT_NEAR(this->GetCentre(), found, 1e-6);
}

TEST_F(GodRaysOcclusionDimming, VolumesDimAlsoInTheMargin)
{
  this->Rays->SetBackgroundGlow(1.0);
  this->Rays->SetBackgroundGlowRadius(90.0);
  this->AddSun({ 0.0, 0.0, -1.0 });
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  auto fog = MakeFog(mapper, { 2.5, -1.0, 0.0 }, 0.7);
  this->Renderer->AddVolume(fog);
  this->AddBox({ 3.2, -1.0, 0.3 }, { 0.7, 1.0, 0.3 }); // in the fog
  // the margin's picture is a wider picture
  this->Rays->SetLayerMargin(0.25);
  auto margin = this->GetLayer();
  mapper->SetImageSampleDistance(2.0f); // VTK draws it into the picture's size: misplaced, no error
  this->GetLayer();
  mapper->SetImageSampleDistance(1.0f);
  this->Rays->SetLayerMargin(0.0);
  this->Scene.Window->SetSize(Width * 3 / 2, Height * 3 / 2);
  this->Renderer->GetActiveCamera()->SetViewAngle(
    2.0 * vtkMath::DegreesFromRadians(std::atan(1.5 * GetTangent(this->Renderer))));
  auto wide = this->GetLayer();
  int different = 0;
  int dimmed = 0;
  ForEachPixel(wide,
    [&](int x, int y)
    {
      different += std::abs(GetValue(wide, x, y) - GetValue(margin, x, y)) > 0.02;
      dimmed += GetValue(wide, x, y) < 0.99;
    });
  EXPECT_GT(dimmed, 1000);
  EXPECT_LE(different, dimmed / 50); // the edges of the box, one row or column
}

TEST_F(GodRaysOcclusionDimming, SmartVolumeMappersDimAlso)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetRequestedRenderModeToGPU();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  this->Renderer->AddVolume(MakeFog(mapper, { 0.0, 0.0, 0.0 }, 0.5));
  EXPECT_NEAR(this->GetCentre(), 0.25, 0.02);
}

// Of its parts, a vtkPropAssembly tells actors and volumes to nobody.
TEST_F(GodRaysOcclusionDimming, VolumesInAssembliesDimAlso)
{
  this->AddSun({ 0.0, 0.0, -1.0 });
  this->Rays->SetSunAngularRadius(3.0);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  vtkNew<vtkPropAssembly> inner;
  inner->AddPart(MakeFog(mapper, { 0.0, 0.0, 0.0 }, 0.5));
  vtkNew<vtkPropAssembly> outer;
  outer->AddPart(inner);
  this->Renderer->AddViewProp(outer);
  EXPECT_NEAR(this->GetCentre(), 0.25, 0.02);
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "opacity of 1 translucent")) << this->Rays->GetPlan();
}
