// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkGodRaysViewDepths: depths that are read from a texture, and those that a shader finds, against double
// precision, for every format of a depth buffer.

#include "GodRaysTesting.h"

#include "vtkGodRaysTarget.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepths.h"

#include "vtkCamera.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cmath>
#include <vector>

using namespace GodRaysTesting;

namespace
{
/// A format of a depth buffer.
struct Buffer
{
  const char* Name;
  unsigned int Format;
};

void PrintTo(const Buffer& buffer, std::ostream* os)
{
  *os << buffer.Name;
}

const Buffer Buffers[] = { { "Fixed16", GL_DEPTH_COMPONENT16 }, { "Fixed24", GL_DEPTH_COMPONENT24 },
  { "Fixed24WithStencil", GL_DEPTH24_STENCIL8 }, { "Fixed32", GL_DEPTH_COMPONENT32 },
  { "Float32", GL_DEPTH_COMPONENT32F } };

class GodRaysViewDepths : public ::testing::TestWithParam<Buffer>
{
protected:
  static constexpr int Width = 67; // of no whole number of vectors
  static constexpr int Height = 41;

  Messages VTKMessages;
  vtkNew<vtkRenderWindow> AnyWindow;
  vtkNew<vtkRenderer> Renderer;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkGodRaysTarget Target;
  vtkGodRaysViewDepths Depths;
  vtkGodRaysView View;
  std::vector<float> Buffered; // window depths

  void SetUp() override
  {
    this->AnyWindow->SetOffScreenRendering(1);
    this->AnyWindow->SetSize(Width, Height);
    this->AnyWindow->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->SetClippingRange(0.5, 200.0);
    this->AnyWindow->Render();
    this->Window = vtkOpenGLRenderWindow::SafeDownCast(this->AnyWindow);
    ASSERT_NE(this->Window, nullptr);
    this->Target.Prepare(this->Window, Width, Height, { 0, GetParam().Format });
    for (int i = 0; i < Width * Height; ++i)
    {
      const double part = i / (Width * Height - 1.0); // to 1, and most of them near it
      this->Buffered.push_back(static_cast<float>(1.0 - std::pow(1.0 - part, 3.0)));
    }
    this->Target.WriteDepth(this->Buffered);
    this->Buffered = this->Target.ReadDepth(); // as the format rounds them
  }

  void TearDown() override
  {
    this->Depths.Release(this->Window);
    this->Target.Release(this->Window);
  }

  void Begin(bool parallel)
  {
    const int size[2] = { Width, Height };
    this->Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    this->View.Set(this->Renderer, size, 0.0);
    this->Depths.Begin(this->Window, this->View, this->Target.GetDepth(), nullptr);
  }

  // Whether depths are those of the buffer, but for the rounding of 32-bit floats.
  void Check(const std::vector<float>& depths) const
  {
    const int size[2] = { Width, Height };
    vtkGodRaysView::Pinhole pinhole;
    ASSERT_TRUE(this->View.GetPinhole(size, pinhole));
    const double* terms = pinhole.Depth;
    const auto find = [&](double rest)
    { return (terms[0] + terms[1] * rest) / (terms[2] + terms[3] * rest); };
    const double rounding = 2e-7;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      const double rest = 1.0 - this->Buffered[i];
      if (rest < rounding)
      {
        EXPECT_TRUE(depths[i] >= find(rounding) * (1.0 - 1e-5)) << i << ": " << depths[i];
        continue;
      }
      EXPECT_LE(depths[i], find(rest - rounding) * (1.0 + 1e-5)) << i;
      EXPECT_GE(depths[i], find(rest + rounding) * (1.0 - 1e-5)) << i;
    }
    EXPECT_EQ(depths.back(), vtkGodRaysViewDepths::OpenSky);
  }
};
}

TEST_P(GodRaysViewDepths, AreTheSameReadAndDrawn)
{
  for (const bool parallel : { false, true })
  {
    SCOPED_TRACE(parallel ? "parallel" : "perspective");
    this->Begin(parallel);
    std::vector<float> read(Width * Height);
    ASSERT_TRUE(this->Depths.ReadEnds(read.data()));
    this->Check(read);
    vtkGodRaysTarget* const drawn = this->Depths.GetEnds();
    ASSERT_NE(drawn, nullptr);
    std::vector<float> shown(Width * Height);
    drawn->Read(GL_RED, GL_FLOAT, shown.data(), 0);
    this->Check(shown);
    ASSERT_TRUE(this->Depths.ReadEnds(read.data())); // what is drawn by now
    EXPECT_EQ(read, shown);
    this->Depths.End();
  }
}

INSTANTIATE_TEST_SUITE_P(All, GodRaysViewDepths, ::testing::ValuesIn(Buffers),
  [](const auto& info) { return info.param.Name; });
