// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSurfacePass.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"

#include <algorithm>

namespace
{
bool HasPass(vtkProp* prop, vtkObjectBase* pass)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  bool has = false;
  for (int i = 0; keys && i < key->Length(keys); ++i)
  {
    has = has || key->Get(keys, i) == pass;
  }
  return has;
}
}

int vtkGodRaysSurfacePass::CountBefore(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  int count = 0;
  for (int i = 0; keys && i < RenderPasses()->Length(keys); ++i)
  {
    vtkObjectBase* pass = RenderPasses()->Get(keys, i);
    if (pass == this)
    {
      return count;
    }
    count += pass->IsA(this->GetClassName()) ? 1 : 0;
  }
  return count;
}

void vtkGodRaysSurfacePass::TakeProps(vtkPropCollection* all)
{
  std::size_t same = 0;
  int count = 0;
  vtkCollectionSimpleIterator iterator;
  all->InitTraversal(iterator);
  for (; vtkProp* prop = all->GetNextProp(iterator); ++count)
  {
    same += same < this->Props.size() && this->Props[same] == prop && HasPass(prop, this) ? 1 : 0;
  }
  if (same == this->Props.size() && count == static_cast<int>(same))
  {
    return;
  }
  std::vector<vtkWeakPointer<vtkProp>> former;
  former.swap(this->Props);
  all->InitTraversal(iterator);
  while (vtkProp* prop = all->GetNextProp(iterator))
  {
    this->Props.emplace_back(prop);
  }
  // First from those that have left the renderer: one that stays may share its keys with them.
  for (const auto& prop : former)
  {
    if (std::find(this->Props.begin(), this->Props.end(), prop) == this->Props.end())
    {
      this->RemoveFrom(prop);
    }
  }
  for (vtkProp* prop : this->Props)
  {
    if (!prop->GetPropertyKeys())
    {
      vtkNew<vtkInformation> keys;
      prop->SetPropertyKeys(keys);
    }
    if (!HasPass(prop, this))
    {
      RenderPasses()->Append(prop->GetPropertyKeys(), this);
    }
  }
}

void vtkGodRaysSurfacePass::RemoveFrom(vtkProp* prop)
{
  if (prop && HasPass(prop, this))
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    RenderPasses()->Remove(keys, this);
    if (RenderPasses()->Length(keys) == 0)
    {
      keys->Remove(RenderPasses());
    }
  }
}

void vtkGodRaysSurfacePass::Remove()
{
  for (const auto& prop : this->Props)
  {
    this->RemoveFrom(prop);
  }
  this->Props.clear();
}
