// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Phase functions. Which there are: vtkGodRaysPhaseFunction.h, of which the constants PHASE_... and
// PhaseHasAsymmetry() come.

//VTK::GodRays::Types
//VTK::GodRays::PhaseFunctions

// How a medium scatters light into directions [1/sr]; the integral over all is 1.
// cosAngle is the cosine of the scattering angle, between the directions in which the light travels
// before and after: 1 is straight on, as for an eye that looks at the light, for which it is the
// cosine of the angle between the view ray and the direction to the light.
struct PhaseFunction
{
  int Kind;       // PHASE_ISOTROPIC or another
  Real Asymmetry; // g, where PhaseHasAsymmetry(Kind): nearly the mean cosine; in (-1, 1) [no unit]
};

// Formula: 1/(4 pi). [1/sr]
FUNCTION RealPerSolidAngle PhaseIsotropic()
{
  return RealPerSolidAngle(0.07957747154594767);
}

// Formula: 3/(16 pi) (1 + c^2). [1/sr] [Chandrasekhar1960]
FUNCTION RealPerSolidAngle PhaseRayleigh(IN(Real) cosAngle)
{
  GODRAYS_EXPECT(IsCosine(cosAngle));
  return RealPerSolidAngle(0.05968310365946075) * (1.0 + cosAngle * cosAngle);
}

// The square of 1 - 2 g c + g^2, without cancellation near the peak.
// Formula: (1 - |g|)^2 + 2 |g| (1 - sign(g) c). [no unit]
FUNCTION Real PhaseDistance(IN(Real) cosAngle, IN(Real) g)
{
  GODRAYS_EXPECT(IsCosine(cosAngle) && abs(g) < 1.0);
  Real sharpness = 1.0 - abs(g);
  Real away = max(1.0 - (g < 0.0 ? -cosAngle : cosAngle), 0.0);
  return sharpness * sharpness + 2.0 * abs(g) * away;
}

// Formula: 1/(4 pi) (1 - g^2)/(1 - 2 g c + g^2)^(3/2). [1/sr] [HenyeyGreenstein1941]
FUNCTION RealPerSolidAngle PhaseHenyeyGreenstein(IN(Real) cosAngle, IN(Real) g)
{
  GODRAYS_EXPECT(IsCosine(cosAngle) && abs(g) < 1.0);
  Real distance = PhaseDistance(cosAngle, g);
  return RealPerSolidAngle(0.07957747154594767) * (1.0 - g * g) / (distance * sqrt(distance));
}

// Rayleigh's for g = 0. Its mean cosine is 3 g (4 + g^2)/(5 (2 + g^2)).
// Formula: 3/(8 pi) (1 - g^2)/(2 + g^2) (1 + c^2)/(1 - 2 g c + g^2)^(3/2). [1/sr]
// [CornetteShanks1992]
FUNCTION RealPerSolidAngle PhaseCornetteShanks(IN(Real) cosAngle, IN(Real) g)
{
  GODRAYS_EXPECT(IsCosine(cosAngle) && abs(g) < 1.0);
  return 1.5 * (1.0 + cosAngle * cosAngle) / (2.0 + g * g) * PhaseHenyeyGreenstein(cosAngle, g);
}

// The parameter of Schlick's phase function for a given g. The fit exceeds 1 from g = 0.94 on, which
// no phase function may.
// Formula: 1.55 g - 0.55 g^3, within [-0.995, 0.995]. [no unit] [PharrHumphreys2004]
FUNCTION Real SchlickParameter(IN(Real) g)
{
  GODRAYS_EXPECT(abs(g) < 1.0);
  return clamp(g * (1.55 - 0.55 * g * g), -0.995, 0.995);
}

// Near Henyey-Greenstein's of the same g, without a root.
// Formula: 1/(4 pi) (1 - k^2)/(1 - k c)^2, k = SchlickParameter(g). [1/sr] [Blasi1993]
FUNCTION RealPerSolidAngle PhaseSchlick(IN(Real) cosAngle, IN(Real) g)
{
  GODRAYS_EXPECT(IsCosine(cosAngle) && abs(g) < 1.0);
  Real k = SchlickParameter(g);
  Real away = max(1.0 - (k < 0.0 ? -cosAngle : cosAngle), 0.0);
  Real distance = (1.0 - abs(k)) + abs(k) * away;
  return RealPerSolidAngle(0.07957747154594767) * (1.0 - k * k) / (distance * distance);
}

// Formula: that of its kind. [1/sr]
FUNCTION RealPerSolidAngle Phase(IN(PhaseFunction) phase, IN(Real) cosAngle)
{
  if (phase.Kind == PHASE_RAYLEIGH)
  {
    return PhaseRayleigh(cosAngle);
  }
  if (phase.Kind == PHASE_HENYEY_GREENSTEIN)
  {
    return PhaseHenyeyGreenstein(cosAngle, phase.Asymmetry);
  }
  if (phase.Kind == PHASE_CORNETTE_SHANKS)
  {
    return PhaseCornetteShanks(cosAngle, phase.Asymmetry);
  }
  if (phase.Kind == PHASE_SCHLICK)
  {
    return PhaseSchlick(cosAngle, phase.Asymmetry);
  }
  return PhaseIsotropic();
}

// Where a phase function has poles as a function of t, the tangent of half the scattering angle: at +-i and,
// where it has an asymmetry, at +-i times this, which is small for a sharp peak ahead. For a peak to the back
// that is above 1, and 1 is returned.
// Formula: (1 - g)/(1 + g), where 1 - 2 g c + g^2 = 0 for c = (1 - t^2)/(1 + t^2); for Schlick's
// sqrt((1 - k)/(1 + k)), where 1 - k c = 0. [no unit]
FUNCTION Real PhasePole(IN(PhaseFunction) phase)
{
  GODRAYS_EXPECT(abs(phase.Asymmetry) < 1.0);
  if (!PhaseHasAsymmetry(phase.Kind) || phase.Asymmetry < 0.0)
  {
    return 1.0;
  }
  if (phase.Kind == PHASE_SCHLICK)
  {
    Real k = SchlickParameter(phase.Asymmetry);
    return sqrt((1.0 - k) / (1.0 + k));
  }
  return (1.0 - phase.Asymmetry) / (1.0 + phase.Asymmetry);
}

// The part of scattered light that goes on nearly straight: where light is scattered more than once it
// counts as not scattered.
// Formula: g^2 for g > 0, else 0. [no unit] [Joseph1976]
FUNCTION Real PhaseForwardPeak(IN(PhaseFunction) phase)
{
  GODRAYS_EXPECT(abs(phase.Asymmetry) < 1.0);
  Real g = max(phase.Asymmetry, 0.0);
  return PhaseHasAsymmetry(phase.Kind) ? g * g : 0.0;
}

// A mix of two, e.g. of a peak ahead and one to the back; weight is the second's part, in [0, 1].
// Formula: (1 - weight) first + weight second. [1/sr]
FUNCTION RealPerSolidAngle PhaseMix(IN(PhaseFunction) first, IN(PhaseFunction) second, IN(Real) weight,
  IN(Real) cosAngle)
{
  GODRAYS_EXPECT(weight >= 0.0 && weight <= 1.0);
  return (1.0 - weight) * Phase(first, cosAngle) + weight * Phase(second, cosAngle);
}
