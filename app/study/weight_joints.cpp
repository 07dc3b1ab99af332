#include "app/study/weight_joints.h"

#include <algorithm>
#include <cmath>

namespace dougong::app {
namespace {

std::string name_of(const structures::FaceLoad& face, const engine::Scene& scene,
                    const engine::Model& model) {
  return face.bonded ? scene.bonds[face.bond].name : model.names[face.a] + " / " + model.names[face.b];
}

}  // namespace

std::vector<WeightJoint> weight_joints(const engine::Scene& scene, const engine::Model& model,
                                       const std::vector<structures::FaceLoad>& faces) {
  std::vector<WeightJoint> joints;
  for (const std::size_t i : structures::by_use(faces)) {
    const structures::FaceLoad& f = faces[i];
    joints.push_back({name_of(f, scene, model), f.bonded, f.start, f.end, f.normal, f.shear, f.eccentricity,
                      f.compression, f.tension, f.used, to_string(f.limit), f.a, f.b, f.through, f.stiffness,
                      f.blocks_stiffness});
  }
  return joints;
}

double movement(const MovedJoint& joint) {
  return std::max(joint.opening.value, std::abs(joint.slip.value));
}

std::vector<MovedJoint> moved_joints(const engine::Scene& scene, const engine::Model& model,
                                     const structures::JointForceRecorder& recorder,
                                     const structures::Trajectory& trajectory,
                                     const std::vector<structures::BlockLoss>& losses) {
  const std::vector<structures::JointMotion> motions =
      structures::joint_motions(recorder.joints(), trajectory, losses);
  std::vector<MovedJoint> joints;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const structures::FaceLoad& f = recorder.joints()[i];
    const structures::JointMotion& m = motions[i];
    const structures::JointForces& force = recorder.forces()[i];
    joints.push_back({name_of(f, scene, model), f.bonded, f.start, f.end, m.opening, m.slip,
                      m.residual_opening, m.residual_slip, force.compression, force.tension, force.shear});
  }
  std::ranges::stable_sort(joints, std::greater<>{}, movement);
  return joints;
}

}  // namespace dougong::app
