// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRole.h"

#include "vtkActor2D.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkProp3D.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"

vtkInformationIntegerKey* vtkGodRaysGetRoleKey()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("ROLE", "vtkGodRaysPass");
  return key;
}

vtkGodRaysRole vtkGodRaysGetRole(vtkProp* prop)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  vtkInformationIntegerKey* key = vtkGodRaysGetRoleKey();
  return keys && keys->Has(key) ? static_cast<vtkGodRaysRole>(keys->Get(key))
                                : vtkGodRaysRole::AUTOMATIC;
}

void vtkGodRaysSetRole(vtkProp* prop, vtkGodRaysRole role)
{
  if (vtkGodRaysGetRole(prop) == role)
  {
    return;
  }
  // A copy, since props may share their keys, as those made by vtkActor::ShallowCopy() do.
  vtkNew<vtkInformation> keys;
  if (vtkInformation* former = prop->GetPropertyKeys())
  {
    keys->Copy(former);
  }
  if (role == vtkGodRaysRole::AUTOMATIC)
  {
    keys->Remove(vtkGodRaysGetRoleKey());
  }
  else
  {
    keys->Set(vtkGodRaysGetRoleKey(), static_cast<int>(role));
  }
  prop->SetPropertyKeys(keys);
}

bool vtkGodRaysIsOverlay(vtkProp* prop)
{
  return vtkActor2D::SafeDownCast(prop) || (!vtkProp3D::SafeDownCast(prop) && !prop->GetBounds());
}

bool vtkGodRaysHasVolume(vtkProp* prop)
{
  vtkNew<vtkPropCollection> volumes;
  prop->GetVolumes(volumes);
  if (volumes->GetNumberOfItems() > 0)
  {
    return true;
  }
  // A vtkPropAssembly does not tell them.
  auto assembly = vtkPropAssembly::SafeDownCast(prop);
  for (int i = 0; assembly && i < assembly->GetParts()->GetNumberOfItems(); ++i)
  {
    if (vtkGodRaysHasVolume(vtkProp::SafeDownCast(assembly->GetParts()->GetItemAsObject(i))))
    {
      return true;
    }
  }
  return false;
}
