// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The types of the formulas on the graphics card. Their C++ twin: vtkGodRaysMath.h.
// A layer has one level of detail and is read inside loops, hence textureLod.
#define Real float
#define Vec2 vec2
#define Vec3 vec3
#define Vec4 vec4
// Numbers with a unit, which Testing/Math/GodRaysUnits.h proves.
#define RealLength float
#define RealArea float
#define RealPerLength float
#define RealAngle float
#define RealSolidAngle float
#define RealPerSolidAngle float
#define RealPerLengthSolidAngle float
#define RealPerAreaSolidAngle float
#define Vec2Length vec2
#define Layer sampler2D
#define LAYER_TEMPLATE
#define FUNCTION
#define IN(T) in T
#define INOUT(T) inout T
#define SampleLayer(layer, uv) (textureLod(layer, uv, 0.0).rgb)
