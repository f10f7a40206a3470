//VTK::System::Dec
//VTK::Output::Dec

// The radial integral by taps along the part of the march that is within the layer.

in vec2 texCoord; // of the picture, as well as it is interpolated

//VTK::GodRays::Terms
//VTK::GodRays::Radial

uniform vec2 size;      // of the picture [pixels]
uniform vec2 layerSize; // [pixels]
uniform vec2 origin;    // of the picture's first pixel in the layer [pixels, centres are whole]
uniform vec2 pixel;     // distance of the picture's pixels [pixels of the layer]
uniform sampler2D layer;
uniform vec2 marchConstant; // from the point p, marchConstant - marchSlope p [pixels]
uniform float marchSlope;
uniform float k;            // the kernel is e^(-k t)
uniform float reach;        // beyond it the kernel is 0 [fraction of the march]
uniform float tapsPerPixel; // [1/pixel]
uniform vec3 gain;

void main()
{
  vec2 point = origin + floor(texCoord * size) * pixel;
  vec2 march = marchConstant - marchSlope * point;
  vec2 uv = (point + 0.5) / layerSize;
  vec2 part = ClipMarch(uv, march / layerSize, 0.5 / layerSize);
  part.y = min(part.y, reach);
  vec3 mean = vec3(0.0);
  if (part.x < part.y)
  {
    int taps = int(clamp(ceil((part.y - part.x) * length(march) * tapsPerPixel), 16.0, 32768.0));
    mean = MeanAlongMarch(layer, uv, march / layerSize, k, part, taps);
  }
  gl_FragData[0] = vec4(gain * (OneChannel ? vec3(mean.r) : mean), 1.0);
}
