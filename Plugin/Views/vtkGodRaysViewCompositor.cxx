// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysViewCompositor.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkGodRaysViewCompositor);

namespace
{
template <typename Value>
void ReduceOnAll(Value* values, std::size_t count, vtkGodRaysCompositor::Operation operation)
{
  const int operations[] = { vtkCommunicator::MIN_OP, vtkCommunicator::MAX_OP,
    vtkCommunicator::PRODUCT_OP, vtkCommunicator::SUM_OP };
  std::vector<Value> own(values, values + count);
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    own.data(), values, static_cast<vtkIdType>(count), operations[operation]);
}
}

void vtkGodRaysViewCompositor::Background::Get(vtkRenderer* renderer)
{
  renderer->GetBackground(this->Color);
  this->Gradient = renderer->GetGradientBackground();
  this->Textured = renderer->GetTexturedBackground();
}

void vtkGodRaysViewCompositor::Background::Set(vtkRenderer* renderer) const
{
  renderer->SetBackground(this->Color[0], this->Color[1], this->Color[2]);
  renderer->SetGradientBackground(this->Gradient);
  renderer->SetTexturedBackground(this->Textured);
}

bool vtkGodRaysViewCompositor::Background::operator==(const Background& other) const
{
  return std::equal(this->Color, this->Color + 3, other.Color) &&
    this->Gradient == other.Gradient && this->Textured == other.Textured;
}

void vtkGodRaysViewCompositor::Update(vtkRenderer* renderer, bool distributed, bool hasDepth)
{
  this->Wanted.Get(renderer);
  this->Distributed = distributed;
  this->Depth = hasDepth;
}

bool vtkGodRaysViewCompositor::IsRoot()
{
  return !this->Distributed ||
    vtkMultiProcessController::GetGlobalController()->GetLocalProcessId() == 0;
}

void vtkGodRaysViewCompositor::Reduce(float* values, std::size_t count, Operation operation)
{
  ReduceOnAll(values, count, operation);
}

void vtkGodRaysViewCompositor::Reduce(double* values, std::size_t count, Operation operation)
{
  ReduceOnAll(values, count, operation);
}

bool vtkGodRaysViewCompositor::DrawBackground(vtkRenderer* renderer)
{
  Background actual;
  actual.Get(renderer);
  if (actual == this->Wanted)
  {
    return false;
  }
  this->Wanted.Set(renderer);
  renderer->Clear();
  actual.Set(renderer);
  return true;
}

void vtkGodRaysViewCompositor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Distributed: " << (this->Distributed ? "yes" : "no") << "\n";
  os << indent << "Depth: " << (this->Depth ? "yes" : "no") << "\n";
}
