// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSurfaceShadows
 * @brief   shadows of a renderer's lights on its surfaces; private to this module
 *
 * Draws a shadow map for each light of the renderer that stands in the scene, and takes part in the
 * mappers' shaders: before VTK's own text for lights, the colour of each such light becomes that colour
 * times how much of the light reaches the fragment. No line of VTK's is replaced, so that all that it does
 * with lights is shadowed: Phong, flat and physically based shading, textures, glyphs, translucent
 * surfaces, and shaders of users. Mappers without lights in their shaders, such as those of volumes, are
 * drawn as ever. See Documentation/Decisions/0021-surface-shadows.md.
 *
 * Maps are kept while light and occluders stay, see vtkGodRaysShadowMap. Each light has one of what is
 * opaque, and one of translucent surfaces and volumes, in which few texels are enough. Headlights cast no
 * shadow that one could see.
 */

#ifndef vtkGodRaysSurfaceShadows_h
#define vtkGodRaysSurfaceShadows_h

#include "vtkGodRaysLight.h"
#include "vtkGodRaysLightFinder.h"
#include "vtkGodRaysShadowMap.h"
#include "vtkGodRaysSortedProps.h"
#include "vtkGodRaysSurfacePass.h"
#include "vtkGodRaysTarget.h"
#include "vtkLight.h" // For vtkSmartPointer
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <array>
#include <deque>
#include <set>
#include <string>
#include <vector>

class vtkGodRaysCompositor;
class vtkGodRaysSceneSize;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
struct vtkGodRaysMedium;
struct vtkGodRaysView;

class vtkGodRaysSurfaceShadows : public vtkGodRaysSurfacePass
{
public:
  static vtkGodRaysSurfaceShadows* New();
  vtkTypeMacro(vtkGodRaysSurfaceShadows, vtkGodRaysSurfacePass);

  /// So many lights have maps, the strongest ones. All are in one texture, and their layers in another.
  static constexpr std::size_t MaximumLights = 8;

  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr; ///< its context is current
    vtkRenderer* Renderer = nullptr;
    const vtkGodRaysView* View = nullptr;
    int Size[2] = { 0, 0 };                   ///< of the picture [pixels]
    double Tiles = 1.0;                       ///< of such a size, across or up a large screenshot
    const vtkGodRaysMedium* Medium = nullptr; ///< that light comes through; null: none
    bool UntaggedPropsOcclude = true;
    std::vector<vtkLight*> WithoutShadows; ///< lights that cast none
    double SunAngularRadius = 0.0;         ///< of lights that are infinitely far [radians]
    double SourceRadius = 0.0; ///< of others [scene units]; 0: as the scene's size suggests
    const vtkGodRaysSceneSize* Scene = nullptr;
    double Diagonal = 0.0; ///< of the scene
    double Away = 0.0;     ///< how far it reaches from the origin
    bool Soft = false;     ///< whether shadows are as soft as these say
    double MostDataShadow =
      1.0; ///< part of a light that shadows take from props coloured by scalars
    vtkGodRaysCompositor* Compositor = nullptr;
  };

  /**
   * Begin a frame: put this pass on the renderer's props, and draw the maps. Returns false when the driver
   * refuses; then there are no shadows.
   */
  bool Begin(const Request& request);

  /**
   * Say whether what is drawn next has the shadows: the scene has, maps and layers do without.
   */
  void SetActive(bool active);

  /**
   * End a frame, if one has begun.
   */
  void End();

  /// Ends the frame at the end of its scope.
  struct Ending
  {
    vtkGodRaysSurfaceShadows* Shadows;
    ~Ending() { this->Shadows->End(); }
  };

  /**
   * Tells for the plan what was drawn.
   */
  std::string Describe() const;

  /**
   * Returns which lights of the last frame cast no shadows, with the cause and the remedy, each as "of ...".
   */
  const std::vector<std::string>& GetFaults() const { return this->Faults; }

  /**
   * Returns whether the last frame had a light that casts shadows where something blocks it.
   */
  bool HasLights() const { return this->Standing > 0; }

  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /// For VTK.
  vtkMTimeType GetShaderStageMTime() override { return this->Stage; }
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  ///@}

protected:
  vtkGodRaysSurfaceShadows() = default;
  ~vtkGodRaysSurfaceShadows() override = default;

private:
  vtkGodRaysSurfaceShadows(const vtkGodRaysSurfaceShadows&) = delete;
  void operator=(const vtkGodRaysSurfaceShadows&) = delete;

  /// Numbers of lights and maps, as shaders have them; see vtkGodRaysSurfaceShadowsFS.glsl.
  struct Uniforms
  {
    float Light[4 * MaximumLights];
    float ToMap[32 * MaximumLights]; // columns first
    float Faces[32 * MaximumLights];
    float Blocks[8 * MaximumLights];
    float Depths[8 * MaximumLights];
  };
  /// Holds what stays of a light from frame to frame.
  struct Kept
  {
    vtkGodRaysShadowMap Maps[2];   // of what is opaque, and of what lets light through
    std::array<int, 4> Parts[2]{}; // of the textures: corner, width and height
    unsigned int Version = 0;      // of the grids that the layers are of
  };
  /// Says what the shaders' text depends on for a light.
  struct Text
  {
    int Number;               // among the lights that are switched on, as VTK numbers them
    std::array<int, 2> Faces; // of its maps; 0: there is none
    bool IsSoft;
    bool IsLamp;
    bool IsDimmed;
    bool operator==(const Text& other) const
    {
      return this->Number == other.Number && this->Faces == other.Faces &&
        this->IsSoft == other.IsSoft && this->IsLamp == other.IsLamp &&
        this->IsDimmed == other.IsDimmed;
    }
  };

  void FindLights(const Request& request, std::vector<vtkGodRaysLight>& lights);
  void FindOccluders(const Request& request);
  bool DrawMaps(const Request& request, const std::vector<vtkGodRaysLight>& lights);
  static double FindShare(const Request& request, const vtkGodRaysMediumIntegrator::Request& scene,
    int size, bool isNested);
  void Describe(
    const Request& request, const vtkGodRaysLight& light, const Kept& kept, std::size_t first);
  bool IsSoft(
    const Request& request, const vtkGodRaysLight& light, const vtkGodRaysShadowFaces& faces) const;
  bool WriteLayers(vtkOpenGLRenderWindow* window, int most);
  void SetMedium(const Request& request);
  std::string GetName(vtkProp* prop, std::string text);

  vtkGodRaysLightFinder Finder;
  vtkGodRaysSortedProps Sorted;
  std::vector<vtkProp*> Occluders[2]; // opaque ones, and those that let light through
  int LayerSize = 0;                  // of maps of the latter [pixels]
  std::deque<Kept> Lights;            // in the frame's order
  vtkGodRaysTarget Atlas;             // of all lights, depths of what is opaque
  vtkGodRaysTarget Layers;            // and what the rest lets through
  std::vector<float> Texels;          // of layers; here to keep its memory
  std::vector<Text> Shaders;          // of the lights that cast shadows
  Uniforms Numbers;                   // of these
  std::string Declarations;           // of the shader that was built last
  std::string Included;               // the same with the formulas that they name
  vtkTimeStamp Stage;                 // when that changed
  bool Active = false;
  std::size_t Standing = 0; // lights in the scene
  std::vector<std::string> Faults;
  double MostDataShadow = 1.0;
  std::vector<vtkSmartPointer<vtkLight>> Shining; // lights that are switched on, by their numbers
  float Air[8];                                   // of the medium, as shaders have it
  float Vertical[4];
  float Planet = 0.0f;
  int Drawn = 0;                       // maps that were drawn anew
  int Built = 0;                       // shaders of this frame
  std::set<std::string> WithoutLights; // mappers whose shaders have none
};

#endif
