#include "app/study/weight_joints.h"

#include "structures/self_weight.h"

namespace dougong::app {

std::vector<WeightJoint> weight_joints(const engine::Scene& scene, const engine::Model& model,
                                       const engine::State& state) {
  const std::vector<structures::FaceLoad> faces = structures::face_loads(model, state);
  std::vector<WeightJoint> joints;
  for (const std::size_t i : structures::by_use(faces)) {
    const structures::FaceLoad& f = faces[i];
    const std::string name =
        f.bonded ? scene.bonds[f.bond].name : model.names[f.a] + " / " + model.names[f.b];
    joints.push_back({name, f.bonded, f.start, f.end, f.normal, f.shear, f.eccentricity, f.compression,
                      f.tension, f.used, to_string(f.limit)});
  }
  return joints;
}

}  // namespace dougong::app
