// Pictures of the building: to scale, y up, with a scale bar, the time, the layout and the motion.
//
// The camera is fixed to the ground and is the same in every picture of a run; it frames the debris too.
// Colour carries the displacement of each block relative to the ground since the start (viridis, light
// is still). When the building hardly moves the displacement is magnified, the factor is written on
// the picture and the undeformed outline is drawn in pale grey.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/block_colour.h"
#include "app/report/camera.h"
#include "app/report/image.h"

namespace dougong::app {

/// What all pictures of a run share.
struct SceneView {
  Box box;                     // m
  double magnification = 1.0;  // of the displacement
  double largest = 1.0;        // at the end of the colour scale: m, or of unit
  double scale = 2.0;          // pixels of the picture per pixel at 1x
  std::string camera = "Camera fixed to the ground.";
  BlockColour colour = BlockColour::displacement;
  std::string unit = "";  // of the colours; empty: a length
  std::string meaning = "displacement relative to the ground since the start";  // of the colours
  double width = 720.0;  // px at 1x, of a single picture; narrow ones stack their annotation
};

/// A moment of the run that is drawn.
struct Frame {
  std::size_t step = 0;
  double time = 0.0;  // s
  std::string caption;
};

/// Six to eight moments: the start, what the run calls moments, the end. Empty without a trajectory.
std::vector<Frame> frames_of(const RunResult& run);
/// The one that shows best what happened: peak drift of a standing building, the end of a fallen one.
const Frame& telling_frame(const RunResult& run, const std::vector<Frame>& frames);
SceneView view_of(const RunResult& run, const std::vector<Frame>& frames);

Image draw_scene(const RunResult& run, const Frame& frame, const SceneView& view);
Image draw_scene(const RunResult& run, std::size_t step);
/// All frames in one picture, each with its time and caption, one scale bar, one legend.
Image draw_film_strip(const RunResult& run, const std::vector<Frame>& frames, const SceneView& view);
/// The building before any run, coloured by storey.
Image draw_model(const ModelSheet& model);

}  // namespace dougong::app
