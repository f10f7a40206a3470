// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes of other grids than images as media of data: resampled, and with the error of that.

#include "../Filters/GodRaysGridScenes.h"
#include "GodRaysMediumTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysVolumeModel.h"

#include "vtkAMRBox.h"
#include "vtkCellCenters.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOverlappingAMR.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointDataToCellData.h"
#include "vtkProbeFilter.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkRectilinearGrid.h"
#include "vtkResampleToImage.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>

using namespace GodRaysTesting;

namespace
{
using Field = std::function<double(const double*)>;

/// Of a place: from 0 to 1 in the box [-1.5, 1.5]^3.
double Ramp(const double* p)
{
  return (4.5 + p[0] + 0.8 * p[1] + 1.2 * p[2]) / 9.0;
}

double Bell(const double* p)
{
  return std::exp(-2.0 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
}

/// Values at the points of a grid, or in its cells.
template <typename Grid>
vtkSmartPointer<Grid> SetValues(
  vtkSmartPointer<Grid> grid, const Field& field, bool ofCells = false)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("smoke");
  if (ofCells)
  {
    vtkNew<vtkCellCenters> centers;
    centers->SetInputData(grid);
    centers->Update();
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      values->InsertNextValue(field(centers->GetOutput()->GetPoint(i)));
    }
    grid->GetCellData()->SetScalars(values);
    return grid;
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(field(grid->GetPoint(i)));
  }
  grid->GetPointData()->SetScalars(values);
  return grid;
}

template <typename Image = vtkImageData>
vtkSmartPointer<Image> MakeImage(int points, double low = -1.5, double high = 1.5)
{
  auto image = vtkSmartPointer<Image>::New();
  image->SetDimensions(points, points, points);
  image->SetOrigin(low, low, low);
  const double spacing = (high - low) / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  return image;
}

/// Cells that are the longer the farther they are from a corner.
vtkSmartPointer<vtkRectilinearGrid> MakeRectilinear(int points)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(points, points, points);
  vtkNew<vtkDoubleArray> places;
  for (int i = 0; i < points; ++i)
  {
    const double t = static_cast<double>(i) / (points - 1);
    places->InsertNextValue(-1.5 + 3.0 * t * (0.5 + 0.5 * t));
  }
  grid->SetXCoordinates(places);
  grid->SetYCoordinates(places);
  grid->SetZCoordinates(places);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra(vtkDataSet* grid)
{
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(grid);
  cut->Update();
  return cut->GetOutput();
}

/// Two levels: one coarse box, of a field, and in its middle a fine one, of another.
vtkSmartPointer<vtkOverlappingAMR> MakeAMR(
  const Field& coarse, const Field& fine, bool ofCells, int ratio = 2)
{
  auto grid = vtkSmartPointer<vtkOverlappingAMR>::New();
  const int blocks[2] = { 1, 1 };
  grid->Initialize(2, blocks);
  const double origin[3] = { -1.5, -1.5, -1.5 };
  grid->SetOrigin(origin);
  grid->SetGridDescription(VTK_XYZ_GRID);
  for (int level = 0; level < 2; ++level)
  {
    auto block = level == 0 ? MakeImage<vtkUniformGrid>(17)
                            : MakeImage<vtkUniformGrid>(8 * ratio + 1, -0.75, 0.75);
    SetValues(block, level == 0 ? coarse : fine, ofCells);
    grid->SetSpacing(level, block->GetSpacing());
    const vtkAMRBox box(block->GetOrigin(), block->GetDimensions(), block->GetSpacing(), origin);
    grid->SetAMRBox(level, 0, box);
    grid->SetDataSet(level, 0, block);
  }
  grid->SetRefinementRatio(0, ratio);
  return grid;
}

/// Takes levels and blocks, as vtkAMRVolumeMapper and vtkMultiBlockVolumeMapper do; not every VTK has those.
class LevelsMapper : public vtkVolumeMapper
{
public:
  static LevelsMapper* New();
  vtkTypeMacro(LevelsMapper, vtkVolumeMapper);
  void Render(vtkRenderer*, vtkVolume*) override {}
  double* GetBounds() override
  {
    for (int i = 0; i < 6; ++i)
    {
      this->Bounds[i] = i % 2 == 0 ? -1.5 : 1.5; // of all that is drawn here
    }
    return this->Bounds;
  }

protected:
  int FillInputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    return 1;
  }
};
vtkStandardNewMacro(LevelsMapper);

class GodRaysVolumeGrids : public MediumTest
{
protected:
  vtkNew<vtkGodRaysVolumeModel> Alone;
  vtkNew<vtkVolume> Smoke;

  GodRaysVolumeGrids()
  {
    this->Scene.Window->SetSize(64, 48);
    // extinction is the value, 0.5 at most
    vtkNew<vtkPiecewiseFunction> opacities;
    for (int i = 0; i <= 256; ++i)
    {
      opacities->AddPoint(i / 256.0, 1.0 - std::exp(-0.5 * i / 256.0));
    }
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    this->Smoke->GetProperty()->SetScalarOpacity(opacities);
    this->Smoke->GetProperty()->SetColor(white);
    this->Smoke->SetPosition(0.0, 0.0, 0.0);
    vtkGodRaysPass::SetRole(this->Smoke, vtkGodRaysPass::MEDIUM);
    this->Alone->SetFarLimit(30.0);
    this->Alone->SetDataResolution(33); // quick
    this->Rays->SetErrorTolerance(1e-3);
    this->Rays->SetModel(this->Alone);
  }

  /// The light of a data set, which must be a medium.
  vtkSmartPointer<vtkImageData> Draw(vtkDataObject* data)
  {
    vtkSmartPointer<vtkAbstractVolumeMapper> mapper;
    if (data->IsA("vtkUnstructuredGrid"))
    {
      mapper = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
    }
    else if (data->IsA("vtkCompositeDataSet"))
    {
      mapper = vtkSmartPointer<LevelsMapper>::New();
    }
    else
    {
      mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
    }
    mapper->SetInputDataObject(data);
    this->Smoke->SetMapper(mapper);
    if (!this->Renderer->HasViewProp(this->Smoke))
    {
      this->Renderer->AddVolume(this->Smoke);
      this->SetLight({ 1.0, 0.4, 0.2, 0.0 });
    }
    auto light = this->GetScattering();
    EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volumes")) << this->Rays->GetPlan();
    return light;
  }

  /// The root mean square difference of two pictures, as a fraction of the brightest pixel of them.
  static double Compare(vtkImageData* a, vtkImageData* b)
  {
    double squares = 0.0;
    double peak = 0.0;
    for (int i = 0; i < 64 * 48; ++i)
    {
      const double x = GetValue(a, i % 64, i / 64);
      const double y = GetValue(b, i % 64, i / 64);
      squares += (x - y) * (x - y);
      peak = std::max({ peak, x, y });
    }
    return std::sqrt(squares / (64 * 48)) / peak;
  }

  /// A number of the last frame's medium; below 0 if it has none of this name.
  double GetNumber(const char* name)
  {
    vtkNew<vtkImageData> numbers;
    EXPECT_TRUE(this->Rays->GetMediumImage(numbers)) << this->Rays->GetPlan();
    vtkDataArray* array = numbers->GetFieldData()->GetArray(name);
    return array ? array->GetTuple1(0) : -1.0;
  }

  /// What the plan says a grid is off by: root mean square, and at most.
  std::array<double, 2> GetToldErrors()
  {
    const std::string plan = this->Rays->GetPlan();
    const auto read = [&](const std::string& before)
    {
      const auto at = plan.find(before);
      EXPECT_NE(at, std::string::npos) << plan;
      return at == std::string::npos ? -1.0 : std::stod(plan.substr(at + before.size()));
    };
    return { read("points, off by "), read("(at most ") };
  }
};
}

// A linear field is one picture, whatever the grid that tells it.
TEST_F(GodRaysVolumeGrids, LinearFieldsAreAsTheirImages)
{
  const auto whole = this->Draw(SetValues(MakeImage(33), Ramp));
  EXPECT_FALSE(Says(this->Rays->GetPlan(), "resampled")) << this->Rays->GetPlan();
  const auto check = [&](const char* name, vtkDataObject* data, double bound, double told)
  {
    const double difference = Compare(whole, this->Draw(data));
    const auto errors = this->GetToldErrors();
    std::cout << name << ": " << difference << " of the peak, told " << errors[0] << ", at most "
              << errors[1] << "\n";
    EXPECT_LT(difference, bound) << name;
    EXPECT_LT(errors[0], told) << name;
    EXPECT_LE(errors[0], errors[1]) << name;
  };
  auto rectilinear = SetValues(MakeRectilinear(33), Ramp);
  check("rectilinear", rectilinear, 1e-4, 1e-5);
  check("tetrahedra", MakeTetrahedra(SetValues(MakeImage(17), Ramp)), 1e-4, 1e-5);
  check("levels", MakeAMR(Ramp, Ramp, false), 1e-4, 1e-5);
  // means of cells about a point lack those outside: half a cell of the outermost ones
  check("cells of an image", SetValues(MakeImage(33), Ramp, true), 1e-3, 0.01);
  check("cells of a rectilinear grid", SetValues(MakeRectilinear(33), Ramp, true), 1e-3, 0.01);
  check("cells of levels", MakeAMR(Ramp, Ramp, true), 2e-3, 0.02);
  // the control: values at the places of an image
  auto wrong = MakeImage(33);
  wrong->GetPointData()->SetScalars(rectilinear->GetPointData()->GetScalars());
  EXPECT_GT(Compare(whole, this->Draw(wrong)), 0.01);
}

// The error that is told is what VTK's own filters find between the grid and the image.
TEST_F(GodRaysVolumeGrids, TellTheErrorOfResampling)
{
  this->Alone->SetWorldUnitInMeters(20.0);
  const auto exact = this->Draw(SetValues(MakeImage(97), Bell));
  EXPECT_EQ(this->GetNumber("DataExtinction_per_m_Error"), 0.0); // nothing was resampled
  EXPECT_EQ(this->GetNumber("DataExtinction_per_m_MaxError"), 0.0);
  auto grid = MakeTetrahedra(SetValues(MakeImage(25), Bell));
  double last[2] = { 1.0, 1.0 };
  for (const int resolution : { 12, 24, 48 })
  {
    this->Alone->SetDataResolution(resolution);
    const double off = Compare(exact, this->Draw(grid));
    const auto told = this->GetToldErrors();

    vtkNew<vtkResampleToImage> resample;
    resample->SetInputDataObject(grid);
    resample->SetSamplingDimensions(resolution, resolution, resolution);
    vtkNew<vtkPointDataToCellData> toCells; // of tetrahedra the centre has the mean
    toCells->SetInputData(grid);
    vtkNew<vtkCellCenters> centers;
    centers->SetInputConnection(toCells->GetOutputPort());
    vtkNew<vtkProbeFilter> probe;
    probe->SetInputConnection(centers->GetOutputPort());
    probe->SetSourceConnection(resample->GetOutputPort());
    probe->Update();
    vtkDataArray* known = toCells->GetOutput()->GetCellData()->GetArray("smoke");
    vtkDataArray* found = probe->GetOutput()->GetPointData()->GetArray("smoke");
    double squares = 0.0;
    double largest = 0.0;
    for (vtkIdType i = 0; i < known->GetNumberOfTuples(); ++i)
    {
      const double difference = std::abs(known->GetTuple1(i) - found->GetTuple1(i));
      squares += difference * difference;
      largest = std::max(largest, difference);
    }
    const double error = std::sqrt(squares / known->GetNumberOfTuples()) / known->GetRange()[1];
    std::cout << resolution << " points: told " << told[0] << " (" << told[1] << "), found "
              << error << ", the picture is off by " << off << "\n";
    EXPECT_NEAR(told[0] / error, 1.0, 0.1);
    const double peak = known->GetRange()[1];
    const double perMeter = 0.5 / 20.0; // the extinction of a value of 1
    const double mean = this->GetNumber("DataExtinction_per_m_Error");
    EXPECT_NEAR(mean / (perMeter * peak * error), 1.0, 0.1);
    // of some of the cells
    EXPECT_NEAR(told[1] / (largest / peak), 1.0, 0.1);
    EXPECT_NEAR(this->GetNumber("DataExtinction_per_m_MaxError") / (perMeter * largest), 1.0, 0.1);
    EXPECT_LT(told[0], 0.6 * last[0]);
    EXPECT_LT(off, last[1]);
    last[0] = told[0];
    last[1] = off;
  }
  EXPECT_LT(last[1], 1e-3);

  // of the worst volume
  const double worst = this->GetNumber("DataExtinction_per_m_Error");
  EXPECT_GT(worst, 0.0);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(SetValues(MakeImage(9), Bell));
  vtkNew<vtkVolume> image;
  image->SetMapper(mapper);
  image->SetProperty(this->Smoke->GetProperty());
  vtkGodRaysPass::SetRole(image, vtkGodRaysPass::MEDIUM);
  this->Renderer->AddVolume(image);
  this->Scene.Window->Render();
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 2 volumes")) << this->Rays->GetPlan();
  EXPECT_EQ(this->GetNumber("DataExtinction_per_m_Error"), worst);

  // haze alone has no such number
  this->Renderer->RemoveVolume(image);
  this->Renderer->RemoveVolume(this->Smoke);
  vtkNew<vtkGodRaysHomogeneousModel> haze;
  haze->SetFarLimit(30.0);
  this->Rays->SetModel(haze);
  this->Scene.Window->Render();
  EXPECT_LT(this->GetNumber("DataExtinction_per_m_Error"), 0.0);
}

// Where there are two levels the finer one counts.
TEST_F(GodRaysVolumeGrids, FinerLevelsCount)
{
  const auto none = [](const double*) { return 0.0; };
  const auto inside = [](const double* p) {
    return 1.0 - std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) / 0.75;
  };
  const auto expected = this->Draw(SetValues(MakeImage(17, -0.75, 0.75), inside));
  EXPECT_LT(Compare(expected, this->Draw(MakeAMR(none, inside, false))), 0.01);
  // the control: the coarse one, where the fine one has nothing
  EXPECT_GT(Compare(expected, this->Draw(MakeAMR(inside, none, false))), 0.05);
}

// A level may have no values: where it is alone there is nothing.
TEST_F(GodRaysVolumeGrids, MayLackValuesInTheFirstPart)
{
  const auto inside = [](const double* p) {
    return 1.0 - std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) / 0.75;
  };
  const auto expected = this->Draw(SetValues(MakeImage(33, -0.75, 0.75), inside));
  EXPECT_GT(Compare(expected, this->Draw(MakeAMR(Ramp, inside, false, 4))), 0.05); // the control
  auto some = MakeAMR(Ramp, inside, false, 4);
  some->GetDataSet(0, 0)->GetPointData()->Initialize();
  EXPECT_LT(Compare(expected, this->Draw(some)), 0.03);
}

// Nor is there anything in cells and at points that are hidden.
TEST_F(GodRaysVolumeGrids, HaveNothingWhereTheyAreBlank)
{
  const auto one = [](const double*) { return 1.0; };
  const auto left = [](const double* p) { return p[0] < 1e-9 ? 1.0 : 0.0; };
  const auto whole = this->Draw(SetValues(MakeImage(33), one));
  const auto expected = this->Draw(SetValues(MakeImage(33), left));
  EXPECT_GT(Compare(expected, whole), 0.05); // the control
  for (const bool ofCells : { false, true })
  {
    const auto half = [](const double* p)
    { return p[0] < 1e-9 ? 1.0 : 0.5; }; // hidden ones are no matter
    auto grid = SetValues(MakeImage<vtkUniformGrid>(33), half, ofCells);
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      if (i % 32 >= 16)
      {
        grid->BlankCell(i);
      }
    }
    EXPECT_LT(Compare(expected, this->Draw(grid)), 1e-6) << ofCells;
  }
  auto grid = SetValues(MakeImage<vtkUniformGrid>(33), one);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    if (i % 33 > 16)
    {
      grid->BlankPoint(i);
    }
  }
  EXPECT_LT(Compare(expected, this->Draw(grid)), 1e-6);
}

// So it is for an image of VTK's most usual class, in a composite, and whatever hidden cells hold.
TEST_F(GodRaysVolumeGrids, HaveNothingWhereTheOnlyPartIsBlank)
{
  const auto left = [](const double* p) { return p[0] < 1e-9 ? 1.0 : 0.0; };
  const auto expected = this->Draw(SetValues(MakeImage(33), left));
  for (const bool ofCells : { false, true })
  {
    const double hidden = ofCells ? 7.0 : 1.0;
    auto image = SetValues(
      MakeImage(33), [&](const double* p) { return p[0] < 1e-9 ? 1.0 : hidden; }, ofCells);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
    {
      ghosts->InsertNextValue(i % 32 >= 16 ? vtkDataSetAttributes::HIDDENCELL : 0);
    }
    image->GetCellData()->AddArray(ghosts);
    EXPECT_LT(Compare(expected, this->Draw(image)), 1e-6) << ofCells;
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, image);
    EXPECT_LT(Compare(expected, this->Draw(blocks)), 1e-6) << ofCells;
  }
}

// What hidden cells of other grids hold is not in the means of those beside them.
TEST_F(GodRaysVolumeGrids, HaveNothingOfHiddenCellsBesideThem)
{
  // Left of the middle of a grid there is smoke; right of it cells are hidden, if they are.
  const auto fill = [](auto grid, double right, bool hides = true)
  {
    SetValues(
      grid, [&](const double* p) { return p[0] < 0.0 ? 0.5 : right; }, true);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      const bool isRight = grid->GetCellData()->GetScalars()->GetTuple1(i) != 0.5;
      ghosts->InsertNextValue(hides && isRight ? vtkDataSetAttributes::HIDDENCELL : 0);
    }
    grid->GetCellData()->AddArray(ghosts);
    return grid;
  };
  using Maker = std::function<vtkSmartPointer<vtkDataObject>(double, bool)>;
  const auto check = [&](const char* name, const Maker& make)
  {
    const auto expected = this->Draw(make(0.0, true));
    EXPECT_GT(GetMean(expected), 0.0) << name;
    EXPECT_LT(Compare(expected, this->Draw(make(1.0, true))), 1e-6) << name;
    EXPECT_GT(Compare(expected, this->Draw(make(1.0, false))), 0.02) << name; // the control
  };
  check("rectilinear",
    [&](double right, bool hides) { return fill(MakeRectilinear(17), right, hides); });
  check("tetrahedra",
    [&](double right, bool hides) { return fill(MakeTetrahedra(MakeImage(9)), right, hides); });
  check("parts",
    [&](double right, bool hides)
    {
      auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      blocks->SetBlock(0, fill(MakeRectilinear(17), right, hides));
      blocks->SetBlock(1, fill(MakeImage(9, 0.6, 1.4), 0.0, hides)); // of hidden ones alone
      return blocks;
    });
}

// Means of whole numbers are none.
TEST_F(GodRaysVolumeGrids, MayHoldWholeNumbers)
{
  const auto mask = [](const double* p) {
    return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) < 0.8 ? 1.0 : 0.0;
  };
  const auto expected = this->Draw(MakeTetrahedra(SetValues(MakeImage(13), mask)));
  auto whole = MakeTetrahedra(SetValues(MakeImage(13), mask));
  vtkNew<vtkUnsignedCharArray> values;
  values->DeepCopy(whole->GetPointData()->GetScalars());
  whole->GetPointData()->SetScalars(values);
  EXPECT_LT(Compare(expected, this->Draw(whole)), 1e-6);
}

// What is outside of a grid does not take entries of the table of its transfer function.
TEST_F(GodRaysVolumeGrids, MayHaveValuesFarFromZero)
{
  const auto inside = [](const double* p) {
    return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) < 1.0;
  };
  const auto grid = [&](double offset)
  {
    auto cells =
      MakeTetrahedra(SetValues(MakeImage(17), [&](const double* p) { return offset + Bell(p); }));
    vtkNew<vtkUnstructuredGrid> some;
    some->SetPoints(cells->GetPoints());
    some->GetPointData()->SetScalars(cells->GetPointData()->GetScalars());
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      double bounds[6];
      cells->GetCellBounds(i, bounds);
      const double center[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
        0.5 * (bounds[4] + bounds[5]) };
      if (inside(center))
      {
        some->InsertNextCell(VTK_TETRA, cells->GetCell(i)->GetPointIds());
      }
    }
    return vtkSmartPointer<vtkUnstructuredGrid>(some);
  };
  const auto expected = this->Draw(grid(0.0));
  const double offset = 1e5;
  vtkPiecewiseFunction* opacities = this->Smoke->GetProperty()->GetScalarOpacity();
  vtkNew<vtkPiecewiseFunction> moved;
  for (int i = 0; i <= 256; ++i)
  {
    moved->AddPoint(offset + i / 256.0, opacities->GetValue(i / 256.0));
  }
  this->Smoke->GetProperty()->SetScalarOpacity(moved);
  EXPECT_LT(Compare(expected, this->Draw(grid(offset))), 1e-4);
}

// Outside of cells there is nothing.
TEST_F(GodRaysVolumeGrids, HaveNothingOutsideOfCells)
{
  auto whole = SetValues(MakeImage(25), [](const double*) { return 1.0; });
  auto all = MakeTetrahedra(whole);
  const double full = GetMean(this->Draw(all));
  this->Alone->SetDataResolution(50);
  vtkNew<vtkPiecewiseFunction>
    opacities; // 0, of which resampling fills what is outside, is smoke, too
  opacities->AddPoint(0.0, 0.4);
  opacities->AddPoint(1.0, 0.4);
  opacities->AddPoint(1.5, 0.0);
  this->Smoke->GetProperty()->SetScalarOpacity(opacities);
  auto half = vtkSmartPointer<vtkUnstructuredGrid>::New();
  half->SetPoints(all->GetPoints());
  half->GetPointData()->ShallowCopy(all->GetPointData());
  half->Allocate(all->GetNumberOfCells());
  for (vtkIdType i = 0; i < all->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    all->GetCellBounds(i, bounds);
    if (bounds[1] < 1e-9 || bounds[0] > 1.3)
    {
      half->InsertNextCell(all->GetCellType(i), all->GetCell(i)->GetPointIds());
    }
  }
  const auto field = [](const double* p) { return p[0] < 0.0 || p[0] > 1.375 ? 1.0 : 2.0; };
  auto left = SetValues(MakeImage(50), field);
  const double expected = GetMean(this->Draw(left));
  EXPECT_NEAR(GetMean(this->Draw(half)) / expected, 1.0, 1e-3);
  EXPECT_LT(expected, 0.85 * full);
}

TEST_F(GodRaysVolumeGrids, AreKeptUntilTheDataChange)
{
  auto grid = MakeTetrahedra(SetValues(MakeImage(17), Bell));
  const double before = GetMean(this->Draw(grid));
  vtkDataArray* values = grid->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, 0.5 * values->GetTuple1(i)); // nobody is told
  }
  this->Alone->SetDataScale(2.0);
  const double scaled = GetMean(this->GetScattering());
  EXPECT_GT(scaled, 1.3 * before);
  this->Alone->SetDataScale(1.0);
  EXPECT_NEAR(GetMean(this->GetScattering()), before, 1e-3 * before);
  values->Modified();
  EXPECT_LT(GetMean(this->GetScattering()), 0.8 * before);
}

// One clear message, and the scene without rays.
TEST_F(GodRaysVolumeGrids, TellWhatCannotBeAMedium)
{
  auto grid = MakeTetrahedra(SetValues(MakeImage(9), Bell));
  this->Draw(grid);
  const auto check = [&](const std::string& words, vtkUnstructuredGrid* bad)
  {
    vtkNew<vtkProjectedTetrahedraMapper> mapper;
    mapper->SetInputData(bad);
    this->Smoke->SetMapper(mapper);
    std::string plan;
    this->Scene.Window->Render();
    plan = this->Rays->GetPlan();
    int told = 0;
    for (const std::string& message : this->VTKMessages.Take())
    {
      told += Says(message, "a prop tagged MEDIUM") && Says(message, words);
    }
    EXPECT_EQ(told, 1) << words << "; " << plan;
    EXPECT_TRUE(Says(plan, "rays: none")) << plan;
    this->Draw(grid);
  };
  vtkNew<vtkUnstructuredGrid> bare;
  bare->CopyStructure(grid);
  check("no scalars at its points or in its cells", bare);
  vtkNew<vtkUnstructuredGrid> empty;
  check("has no data", empty);
  vtkNew<vtkUnstructuredGrid> surface;
  surface->SetPoints(grid->GetPoints());
  surface->GetPointData()->ShallowCopy(grid->GetPointData());
  const vtkIdType triangle[3] = { 0, 1, 90 };
  surface->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  check("no cells of three dimensions", surface);
}
