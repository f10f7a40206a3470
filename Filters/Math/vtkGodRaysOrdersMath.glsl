// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::GodRays::Types

// Light that a medium scatters twice and more, along a view ray. The part f of scattered light that goes on
// nearly straight counts as not scattered [Wiscombe1977]: the scaled extinction is sigma_t - f sigma_s. What
// goes on so from the light to the eye has spread a little by then: its radiance is that of single
// scattering in the scaled medium, with the peak function B in place of the phase function
// [NakajimaTanaka1988]. B depends on n, the mean number of such events on the way from the light to the eye.

// Formula: sigma_t - f sigma_s. [1/length]
FUNCTION Real ScaledExtinction(IN(Real) extinction, IN(Real) scattering, IN(Real) forwardPart)
{
  GODRAYS_EXPECT(extinction >= 0.0 && scattering >= 0.0 && forwardPart >= 0.0 && forwardPart < 1.0);
  return max(extinction - forwardPart * scattering, 0.0);
}

// Where the table of the peak function has an angle and a number of events, which is most at its last row.
// Formula: (((1 - cosAngle)/2)^(1/3), (n/most)^(1/2)). [no unit]
FUNCTION Vec2 PeakPlace(IN(Real) cosAngle, IN(Real) n, IN(Real) most)
{
  GODRAYS_EXPECT(IsCosine(cosAngle) && n >= 0.0 && most > 0.0);
  return Vec2(pow(max(0.5 * (1.0 - cosAngle), 0.0), 1.0 / 3.0), sqrt(min(n / most, 1.0)));
}

// Returns the light of two and more scatterings that a place adds to a view ray, for each length: lit is the
// sum over the lights of their irradiance there, dimmed by the scaled medium, times the peak function,
// source the radiance that is scattered towards the eye for each unit of scaled scattering.
// Formula: sigma_s (lit + (1 - f) source). [radiance/length]
FUNCTION Real OrdersPart(
  IN(Real) scattering, IN(Real) forwardPart, IN(Real) lit, IN(Real) source)
{
  GODRAYS_EXPECT(scattering >= 0.0 && forwardPart >= 0.0 && forwardPart < 1.0);
  return scattering * (lit + (1.0 - forwardPart) * source);
}
