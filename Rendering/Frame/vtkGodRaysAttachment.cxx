// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAttachment.h"

#include "vtkCameraPass.h"
#include "vtkCommand.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkEDLShading.h"
#include "vtkFramebufferPass.h"
#include "vtkGaussianBlurPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkPanoramicProjectionPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkSimpleMotionBlurPass.h"
#include "vtkSobelGradientMagnitudePass.h"
#include "vtkToneMappingPass.h"

#include <map>

namespace
{
// By name: both stand above this.
bool IsRays(vtkRenderPass* pass)
{
  return pass && pass->IsA("vtkGodRaysPass");
}

bool IsSky(vtkRenderPass* pass)
{
  return pass && pass->IsA("vtkGodRaysSkyPass");
}

// Passes that lead back to themselves have no end.
const int DeepestNesting = 32;

/// Call a function with the pass as what it is, if it has one delegate.
template <typename Function>
bool WithDelegate(vtkRenderPass* pass, const Function& function)
{
  if (auto image = vtkImageProcessingPass::SafeDownCast(pass))
  {
    function(image);
    return true;
  }
  if (auto camera = vtkCameraPass::SafeDownCast(pass))
  {
    function(camera);
    return true;
  }
  if (auto supersampling = vtkSSAAPass::SafeDownCast(pass))
  {
    function(supersampling);
    return true;
  }
  return false;
}

/// What a pass has others draw.
std::vector<vtkRenderPass*> GetDelegates(vtkRenderPass* pass)
{
  std::vector<vtkRenderPass*> delegates;
  WithDelegate(pass, [&delegates](auto* each) { delegates.push_back(each->GetDelegatePass()); });
  auto sequence = vtkSequencePass::SafeDownCast(pass);
  if (vtkRenderPassCollection* passes = sequence ? sequence->GetPasses() : nullptr)
  {
    for (int i = 0; i < passes->GetNumberOfItems(); ++i)
    {
      delegates.push_back(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)));
    }
  }
  return delegates;
}

/// The first pass of some kind, of this one and those that it has others draw; null if there is none. Nothing
/// is allocated, as it is looked for in each frame.
vtkRenderPass* FindFirstOf(
  vtkRenderPass* pass, const std::function<bool(vtkRenderPass*)>& is, int depth = 0)
{
  if (!pass || depth == DeepestNesting || is(pass))
  {
    return depth == DeepestNesting ? nullptr : pass;
  }
  vtkRenderPass* found = nullptr;
  WithDelegate(
    pass, [&](auto* each) { found = FindFirstOf(each->GetDelegatePass(), is, depth + 1); });
  auto sequence = vtkSequencePass::SafeDownCast(pass);
  vtkRenderPassCollection* passes = sequence ? sequence->GetPasses() : nullptr;
  for (int i = 0; passes && !found && i < passes->GetNumberOfItems(); ++i)
  {
    found = FindFirstOf(vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)), is, depth + 1);
  }
  return found;
}

/// Make a path longer, by passes that draw each other, until one is of some kind. False if none is.
bool Extend(std::vector<vtkRenderPass*>& path, vtkRenderPass* next,
  const std::function<bool(vtkRenderPass*)>& is)
{
  if (!next || path.size() == DeepestNesting)
  {
    return false;
  }
  path.push_back(next);
  if (is(next))
  {
    return true;
  }
  for (vtkRenderPass* delegate : GetDelegates(next))
  {
    if (Extend(path, delegate, is))
    {
      return true;
    }
  }
  path.pop_back();
  return false;
}

/// Whether a pass works on what is finished below it, so that ours belongs under it. SSAO and EDL shade
/// surfaces, and leave depth behind.
bool IsOver(vtkRenderPass* other, vtkImageProcessingPass* pass)
{
  if (IsRays(other))
  {
    return IsSky(pass);
  }
  return vtkSSAAPass::SafeDownCast(other) ||
    (vtkImageProcessingPass::SafeDownCast(other) && !IsSky(other) &&
      !vtkSSAOPass::SafeDownCast(other) && !vtkEDLShading::SafeDownCast(other) &&
      !vtkPanoramicProjectionPass::SafeDownCast(other));
}

/// The innermost pass that is over ours, null if there is none.
vtkRenderPass* FindInnermostOver(vtkRenderPass* root, vtkImageProcessingPass* pass, int depth = 0)
{
  const bool isOver = IsOver(root, pass);
  if (depth == DeepestNesting || (vtkImageProcessingPass::SafeDownCast(root) && !isOver))
  {
    return nullptr;
  }
  for (vtkRenderPass* delegate : GetDelegates(root))
  {
    if (vtkRenderPass* found = FindInnermostOver(delegate, pass, depth + 1))
    {
      return found;
    }
  }
  return isOver ? root : nullptr;
}
}

vtkInformationKeyRestrictedMacro(
  vtkGodRaysAttachment, PASSES, ObjectBase, "vtkRenderPassCollection");

/// The passes that are attached to a renderer, in the order of Attach(), and their attachments.
class vtkGodRaysAttachment::Passes : public vtkRenderPassCollection
{
public:
  static Passes* New();
  vtkTypeMacro(Passes, vtkRenderPassCollection);

  std::map<vtkRenderPass*, vtkGodRaysAttachment*> Attachments;
};
vtkStandardNewMacro(vtkGodRaysAttachment::Passes);

/// Called when the renderer starts to render. The renderer holds it, and it the pass.
class vtkGodRaysAttachment::Watch : public vtkCommand
{
public:
  static Watch* New() { return new Watch; }
  // For all passes of the renderer, as VTK calls those of one priority in no order of its own: those that
  // were replaced end before one comes back, and they come back in the order in which they were attached.
  void Execute(vtkObject*, unsigned long, void*) override
  {
    vtkRenderer* renderer = this->Attachment->Renderer;
    // What happens here may end this one, and its pass.
    const vtkSmartPointer<Passes> passes = GetPasses(renderer);
    if (!passes)
    {
      this->Attachment->ComeBack(this->Pass, renderer);
      return;
    }
    std::vector<vtkRenderPass*> replaced;
    for (const auto& each : passes->Attachments)
    {
      if (IsReplaced(each.first, passes, renderer))
      {
        replaced.push_back(each.first);
      }
    }
    for (vtkRenderPass* each : replaced)
    {
      vtkGodRaysAttachment* attachment = passes->Attachments[each];
      each->ReleaseGraphicsResources(renderer->GetVTKWindow());
      attachment->Detach(vtkImageProcessingPass::SafeDownCast(each), renderer);
    }
    for (int i = 0; i < passes->GetNumberOfItems(); ++i)
    {
      auto pass = vtkImageProcessingPass::SafeDownCast(passes->GetItemAsObject(i));
      passes->Attachments[pass]->ComeBack(pass, renderer);
    }
  }

  /// Whether another pass of the kind was put in its place, without Detach(), and nobody has it but those of
  /// which the same is true.
  static bool IsReplaced(vtkRenderPass* pass, Passes* passes, vtkRenderer* renderer, int depth = 0)
  {
    const auto isOther = [pass](vtkRenderPass* each)
    { return each != pass && each->IsA(pass->GetClassName()); };
    if (depth == DeepestNesting || !FindFirst(renderer, isOther) ||
      FindFirst(renderer, [pass](vtkRenderPass* each) { return each == pass; }))
    {
      return false;
    }
    int ownReferences = 2; // of its watch, and in the renderer's collection
    for (const auto& each : passes->Attachments)
    {
      const int references =
        each.first == pass ? 0 : each.second->CountReferences(each.first, pass);
      if (references > 0 && IsReplaced(each.first, passes, renderer, depth + 1))
      {
        ownReferences += references;
      }
    }
    return pass->GetReferenceCount() <= ownReferences;
  }

  vtkGodRaysAttachment* Attachment = nullptr; // of the pass
  vtkSmartPointer<vtkImageProcessingPass> Pass;
};

// How often a pass, whose attachment this is, and this have another one.
int vtkGodRaysAttachment::CountReferences(vtkRenderPass* pass, vtkRenderPass* other) const
{
  const auto image = vtkImageProcessingPass::SafeDownCast(pass);
  return (image->GetDelegatePass() == other) + (this->Former == other) +
    (this->FormerDelegate == other);
}

std::vector<vtkRenderPass*> vtkGodRaysAttachment::FindPath(
  vtkRenderer* renderer, const std::function<bool(vtkRenderPass*)>& is)
{
  std::vector<vtkRenderPass*> path;
  Extend(path, renderer->GetPass(), is);
  return path;
}

vtkRenderPass* vtkGodRaysAttachment::FindFirst(
  vtkRenderer* renderer, const std::function<bool(vtkRenderPass*)>& is)
{
  return FindFirstOf(renderer->GetPass(), is);
}

vtkRenderPass* vtkGodRaysAttachment::FindWithoutDepth(vtkRenderPass* delegate)
{
  for (int depth = 0; delegate && depth < DeepestNesting; ++depth)
  {
    if (vtkSSAAPass::SafeDownCast(delegate) || vtkDepthOfFieldPass::SafeDownCast(delegate) ||
      vtkFramebufferPass::SafeDownCast(delegate) || vtkGaussianBlurPass::SafeDownCast(delegate) ||
      vtkSobelGradientMagnitudePass::SafeDownCast(delegate) ||
      vtkSimpleMotionBlurPass::SafeDownCast(delegate) || vtkToneMappingPass::SafeDownCast(delegate))
    {
      return delegate;
    }
    vtkRenderPass* next = nullptr;
    if (IsRays(delegate) || IsSky(delegate) || vtkOpenGLFXAAPass::SafeDownCast(delegate) ||
      vtkCameraPass::SafeDownCast(delegate)) // which draw in place
    {
      WithDelegate(delegate, [&next](auto* each) { next = each->GetDelegatePass(); });
    }
    delegate = next;
  }
  return nullptr;
}

// Null if there is none: a program may have given the renderer other information.
vtkGodRaysAttachment::Passes* vtkGodRaysAttachment::GetPasses(vtkRenderer* renderer)
{
  vtkInformation* information = renderer->GetInformation();
  return information ? Passes::SafeDownCast(information->Get(PASSES())) : nullptr;
}

vtkRenderPass* vtkGodRaysAttachment::FindPass(
  vtkRenderer* renderer, const std::function<bool(vtkRenderPass*)>& is)
{
  if (vtkRenderPass* found = FindFirst(renderer, is))
  {
    return found;
  }
  vtkRenderPassCollection* passes = GetPasses(renderer);
  for (int i = 0; passes && i < passes->GetNumberOfItems(); ++i)
  {
    auto pass = vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i));
    if (is(pass))
    {
      return pass;
    }
  }
  return nullptr;
}

void vtkGodRaysAttachment::Attach(vtkImageProcessingPass* pass, vtkRenderer* renderer)
{
  if (this->Renderer == renderer)
  {
    this->Insert(pass, renderer);
    return;
  }
  if (this->WatchTag) // on a renderer that is gone
  {
    pass->SetDelegatePass(this->FormerDelegate);
  }
  this->Renderer = renderer;
  this->Over = nullptr;
  this->Former = nullptr;
  this->FormerDelegate = pass->GetDelegatePass();
  this->Delegate = this->FormerDelegate;
  this->Insert(pass, renderer);

  vtkNew<Watch> watch;
  watch->Attachment = this;
  watch->Pass = pass;
  // after others that arrange passes in this event
  this->WatchTag = renderer->AddObserver(vtkCommand::StartEvent, watch, -1.0f);
  vtkInformation* information = renderer->GetInformation();
  if (information && !information->Has(PASSES()))
  {
    information->Set(PASSES(), vtkNew<Passes>());
  }
  if (Passes* passes = GetPasses(renderer))
  {
    passes->AddItem(pass);
    passes->Attachments[pass] = this;
  }
}

// Put the pass among the renderer's again, unless somebody who knows of it has put it elsewhere.
void vtkGodRaysAttachment::ComeBack(vtkImageProcessingPass* pass, vtkRenderer* renderer)
{
  vtkRenderPass* delegate = pass->GetDelegatePass();
  if (delegate == this->Delegate || IsSky(delegate))
  {
    this->Insert(pass, renderer);
  }
}

// Put the pass among the renderer's, if it is not among them.
void vtkGodRaysAttachment::Insert(vtkImageProcessingPass* pass, vtkRenderer* renderer)
{
  if (FindFirst(renderer, [pass](vtkRenderPass* each) { return each == pass; }))
  {
    return;
  }
  this->Over = FindInnermostOver(renderer->GetPass(), pass);
  this->Former = this->Over ? GetDelegates(this->Over).front() : renderer->GetPass();
  pass->SetDelegatePass(this->Former ? this->Former : this->FormerDelegate);
  this->Delegate = pass->GetDelegatePass();
  this->Put(pass, renderer);
}

void vtkGodRaysAttachment::Put(vtkRenderPass* pass, vtkRenderer* renderer)
{
  if (!WithDelegate(this->Over, [pass](auto* over) { over->SetDelegatePass(pass); }))
  {
    renderer->SetPass(pass);
  }
}

bool vtkGodRaysAttachment::Has(vtkImageProcessingPass* pass, vtkRenderer* renderer) const
{
  return renderer && (this->Renderer == renderer || renderer->GetPass() == pass);
}

void vtkGodRaysAttachment::Detach(vtkImageProcessingPass* pass, vtkRenderer* renderer)
{
  const vtkSmartPointer<vtkImageProcessingPass> keep = pass;
  const bool attached = this->Renderer == renderer;
  vtkSmartPointer<vtkRenderPass> next = attached ? this->Former : nullptr;
  vtkRenderPass* delegate = pass->GetDelegatePass();
  if (IsSky(delegate) || IsSky(next) || (IsRays(next) && delegate != next))
  {
    // A sky has come under god rays since, and stays, or it or other god rays have gone.
    next = delegate == this->FormerDelegate ? nullptr : delegate;
  }
  const auto path = FindPath(renderer, [pass](vtkRenderPass* each) { return each == pass; });
  vtkRenderPass* over = path.size() > 1 ? path[path.size() - 2] : nullptr;
  if (path.size() == 1 || (over && (over == this->Over || IsRays(over))))
  {
    this->Over = over;
    this->Put(next, renderer);
  }
  if (!attached)
  {
    return;
  }
  renderer->RemoveObserver(this->WatchTag);
  this->WatchTag = 0;
  if (Passes* passes = GetPasses(renderer))
  {
    passes->RemoveItem(pass);
    passes->Attachments.erase(pass);
  }
  pass->SetDelegatePass(this->FormerDelegate);
  this->Over = nullptr;
  this->Former = nullptr;
  this->FormerDelegate = nullptr;
  this->Renderer = nullptr;
}
