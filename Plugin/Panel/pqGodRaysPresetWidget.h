// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   pqGodRaysPresetWidget
 * @brief   a list of presets with their pictures, in ParaView's panel
 *
 * The names are those of the property's vtkSMStringListDomain. Beside each stands a picture of one scene with
 * that preset; the tooltip of an entry has it larger, with the preset's description. A name that is no preset
 * has an icon of sliders: its parameters are set by hand. It is the widget of properties with
 * panel_widget="godrays_preset".
 */

#ifndef pqGodRaysPresetWidget_h
#define pqGodRaysPresetWidget_h

#include "pqPropertyWidget.h"

class pqGodRaysPresetWidget : public pqPropertyWidget
{
  Q_OBJECT

public:
  pqGodRaysPresetWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqGodRaysPresetWidget() override;

private:
  Q_DISABLE_COPY(pqGodRaysPresetWidget)
};

#endif
