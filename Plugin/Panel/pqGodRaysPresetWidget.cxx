// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqGodRaysPresetWidget.h"

#include "vtkGodRaysPresets.h"
#include "vtkSMProperty.h"
#include "vtkSMStringListDomain.h"

#include <QComboBox>
#include <QIcon>
#include <QPainter>
#include <QPixmap>
#include <QVBoxLayout>

namespace
{
const QSize IconSize(48, 36); // of pictures of 4 to 3

// The file of a preset's picture in GodRaysPresets.qrc
QString GetPicture(const QString& preset)
{
  return ":/godrays/presets/" + preset.section(':', -1) + ".png";
}

// Three sliders
QIcon MakeSliders(const QColor& color)
{
  QPixmap picture(IconSize);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 2));
  painter.setBrush(color);
  const int knobs[] = { 30, 16, 24 };
  for (int i = 0; i < 3; ++i)
  {
    const int y = 9 + 9 * i;
    painter.drawLine(10, y, 38, y);
    painter.drawEllipse(QPoint(knobs[i], y), 2, 2);
  }
  return QIcon(picture);
}

QString GetToolTip(const QString& preset)
{
  for (int i = 0; i < vtkGodRaysPresets::GetNumberOfPresets(); ++i)
  {
    if (preset == vtkGodRaysPresets::GetPresetName(i))
    {
      return QString("<p><img src=\"%1\"/></p><p>%2</p>")
        .arg(
          GetPicture(preset), QString(vtkGodRaysPresets::GetPresetDescription(i)).toHtmlEscaped());
    }
  }
  return QString();
}
}

pqGodRaysPresetWidget::pqGodRaysPresetWidget(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parentWidget)
  : pqPropertyWidget(proxy, parentWidget)
{
  auto box = new QComboBox(this);
  box->setObjectName("ComboBox");
  box->setIconSize(IconSize);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);                      // characters
  box->setStyleSheet("QComboBox { combobox-popup: 0; }"); // a list that ends at its last row
  auto names = property->FindDomain<vtkSMStringListDomain>();
  for (unsigned int i = 0; names && i < names->GetNumberOfStrings(); ++i)
  {
    const QString name = names->GetString(i);
    const QPixmap picture(GetPicture(name));
    box->addItem(
      picture.isNull() ? MakeSliders(this->palette().color(QPalette::Text)) : QIcon(picture), name);
    box->setItemData(i, GetToolTip(name), Qt::ToolTipRole);
  }
  box->setMaxVisibleItems(box->count());

  auto layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(box);
  this->addPropertyLink(box, "currentText", SIGNAL(currentTextChanged(const QString&)), property);
}

pqGodRaysPresetWidget::~pqGodRaysPresetWidget() = default;
