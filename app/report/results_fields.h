// The one list of what a results file holds: group, name and unit of every field of a RunResult. The
// writer and the reader both walk it, so they cannot disagree.
//
// An Archive has group(name, inner), optional_group(name, inner) and
// optional_field(...) and optional_column(...) for what older files lack, field(name, unit,
// value), matrix(name, unit, values, shape), rows(name, list, inner) for numbered groups and column(name,
// unit, list, member) for tables.
#pragma once

#include "app/study/run_result.h"

namespace dougong::app {

template <class A, class V>
void walk_named_values(A& a, const char* name, V& values) {
  a.table(name, values, [&] {
    a.column("name", "", values, &NamedValue::name);
    a.column("value", "", values, &NamedValue::value);
    a.column("meaning", "", values, &NamedValue::meaning);
  });
}

template <class A, class V>
void walk_shapes(A& a, const char* name, V& shapes) {
  a.table(name, shapes, [&] {
    a.column("name", "", shapes, &DrawnShape::name);
    a.column("outline", "m", shapes, &DrawnShape::outline);
    a.column("radius", "m", shapes, &DrawnShape::radius);
    a.column("position", "m", shapes, &DrawnShape::position);
    a.column("angle", "rad", shapes, &DrawnShape::angle);
    a.column("mass", "kg", shapes, &DrawnShape::mass);
    a.column("storey", "", shapes, &DrawnShape::storey);
    a.column("material", "", shapes, &DrawnShape::material);
  });
}

template <class A, class R>
void walk_model(A& a, R& model) {
  a.field("layout", "", model.layout);
  a.field("title", "", model.title);
  walk_named_values(a, "parameters", model.parameters);
  walk_named_values(a, "materials", model.materials);
  walk_shapes(a, "blocks", model.blocks);
  walk_shapes(a, "terrains", model.terrains);
  a.table("storeys", model.storeys, [&] {
    a.column("name", "", model.storeys, &StoreySheet::name);
    a.column("base", "m", model.storeys, &StoreySheet::base);
    a.column("height", "m", model.storeys, &StoreySheet::height);
    a.column("mass", "kg", model.storeys, &StoreySheet::mass);
    a.column("blocks", "", model.storeys, &StoreySheet::blocks);
  });
  a.optional_group("connections", [&] {
    a.table("bonds", model.bonded, [&] {
      a.column("name", "", model.bonded, &DrawnBond::name);
      a.column("owner", "", model.bonded, &DrawnBond::owner);
      a.column("start", "m", model.bonded, &DrawnBond::start);
      a.column("end", "m", model.bonded, &DrawnBond::end);
      a.column("cracked", "s", model.bonded, &DrawnBond::cracked);
      a.column("broken", "s", model.bonded, &DrawnBond::broken);
      a.column("mode", "", model.bonded, &DrawnBond::mode);
      a.optional_column("crushed", "s", model.bonded, &DrawnBond::crushed);
    });
    a.table("joints", model.links, [&] {
      a.column("a", "", model.links, &DrawnLink::a);
      a.column("b", "", model.links, &DrawnLink::b);
      a.column("anchor_a", "m", model.links, &DrawnLink::anchor_a);
      a.column("anchor_b", "m", model.links, &DrawnLink::anchor_b);
    });
  });
  a.field("mass", "kg", model.mass);
  a.field("bonds", "", model.bonds);
  a.field("contact_points", "", model.contact_points);
  a.field("period", "s", model.period);
  a.field("period_participation", "1", model.period_participation);
  a.field("modelled", "", model.modelled);
  a.field("not_modelled", "", model.not_modelled);
  a.field("findings", "", model.findings);
}

template <class A, class R>
void walk_motion(A& a, R& motion) {
  a.field("title", "", motion.title);
  walk_named_values(a, "provenance", motion.provenance);
  a.field("processing", "", motion.processing);
  walk_named_values(a, "measures", motion.measures);
  a.field("interval", "s", motion.interval);
  a.field("times", "s", motion.times);
  a.field("acceleration_x", "m/s2", motion.acceleration_x);
  a.field("velocity_x", "m/s", motion.velocity_x);
  a.field("displacement_x", "m", motion.displacement_x);
  a.field("acceleration_y", "m/s2", motion.acceleration_y);
  a.field("velocity_y", "m/s", motion.velocity_y);
  a.field("displacement_y", "m", motion.displacement_y);
  a.field("spectrum_periods", "s", motion.spectrum_periods);
  a.field("spectrum_psa", "m/s2", motion.spectrum_psa);
  a.optional_field("design_name", "", motion.design_name);
  a.optional_field("design_periods", "s", motion.design_periods);
  a.optional_field("design_psa", "m/s2", motion.design_psa);
  a.field("spectrum_at_period", "m/s2", motion.spectrum_at_period);
}

template <class A, class J>
void walk_weight(A& a, J& joints) {
  a.table("joints", joints, [&] {
    a.column("name", "", joints, &WeightJoint::name);
    a.column("bonded", "", joints, &WeightJoint::bonded);
    a.column("start", "m", joints, &WeightJoint::start);
    a.column("end", "m", joints, &WeightJoint::end);
    a.column("normal", "N", joints, &WeightJoint::normal);
    a.column("shear", "N", joints, &WeightJoint::shear);
    a.column("eccentricity", "1", joints, &WeightJoint::eccentricity);
    a.column("compression", "Pa", joints, &WeightJoint::compression);
    a.column("tension", "Pa", joints, &WeightJoint::tension);
    a.column("used", "1", joints, &WeightJoint::used);
    a.column("limit", "", joints, &WeightJoint::limit);
    a.optional_column("a", "", joints, &WeightJoint::a);
    a.optional_column("b", "", joints, &WeightJoint::b);
    a.optional_column("through", "m", joints, &WeightJoint::through);
    a.optional_column("stiffness", "N/m", joints, &WeightJoint::stiffness);
    a.optional_column("blocks_stiffness", "N/m", joints, &WeightJoint::blocks_stiffness);
  });
}

template <class A, class J>
void walk_joint_peak(A& a, const std::string& name, const char* unit, J& joints,
                     structures::Peak MovedJoint::*peak) {
  a.column(name, unit, joints, peak, &structures::Peak::value);
  a.column(name + "_time", "s", joints, peak, &structures::Peak::time);
}

template <class A, class J>
void walk_moved_joints(A& a, J& joints) {
  a.table("joints", joints, [&] {
    a.column("name", "", joints, &MovedJoint::name);
    a.column("bonded", "", joints, &MovedJoint::bonded);
    a.column("start", "m", joints, &MovedJoint::start);
    a.column("end", "m", joints, &MovedJoint::end);
    walk_joint_peak(a, "opening", "m", joints, &MovedJoint::opening);
    walk_joint_peak(a, "slip", "m", joints, &MovedJoint::slip);
    a.column("residual_opening", "m", joints, &MovedJoint::residual_opening);
    a.column("residual_slip", "m", joints, &MovedJoint::residual_slip);
    walk_joint_peak(a, "compression", "N", joints, &MovedJoint::compression);
    walk_joint_peak(a, "tension", "N", joints, &MovedJoint::tension);
    walk_joint_peak(a, "shear", "N", joints, &MovedJoint::shear);
  });
}

template <class A, class R>
void walk_trajectory(A& a, R& trajectory) {
  a.field("times", "s", trajectory.times);
  a.field("blocks", "", trajectory.blocks);
  const std::size_t steps = trajectory.times.size(), blocks = trajectory.blocks;
  a.matrix("poses", "m, m, rad", trajectory.poses, {steps, blocks, 3});
  a.field("ground_displacement", "m", trajectory.ground_displacement);
  a.field("ground_reaction", "N", trajectory.ground_reaction);
  a.matrix("accelerations", "m/s2", trajectory.accelerations, {steps, blocks});
}

template <class A, class E>
void walk_signed_peaks(A& a, const char* unit, E& envelope) {
  a.field("positive", unit, envelope.positive.value);
  a.field("positive_time", "s", envelope.positive.time);
  a.field("negative", unit, envelope.negative.value);
  a.field("negative_time", "s", envelope.negative.time);
}

template <class A, class E>
void walk_envelope(A& a, const char* name, const char* unit, E& envelope) {
  a.group(name, [&] { walk_signed_peaks(a, unit, envelope); });
}

template <class A, class S>
void walk_storey(A& a, S& storey) {
  a.field("name", "", storey.name);
  a.field("height", "m", storey.height);
  a.optional_field("is_base", "", storey.is_base);
  a.field("drift", "1", storey.drift);
  a.field("floor_displacement", "m", storey.floor_displacement);
  a.field("floor_acceleration", "m/s2", storey.floor_acceleration);
  walk_envelope(a, "peak_drift", "1", storey.peak_drift);
  walk_envelope(a, "peak_acceleration", "m/s2", storey.peak_acceleration);
  a.optional_field("shear_drift", "1", storey.shear_drift);
  a.optional_group("peak_shear_drift", [&] { walk_signed_peaks(a, "1", storey.peak_shear_drift); });
  a.field("residual_drift", "1", storey.residual_drift);
  a.field("original_mass", "kg", storey.original_mass);
  a.field("mass_lost", "1", storey.mass_lost);
  a.field("lost_at", "s", storey.lost_at);
  a.field("lost_because", "", storey.lost_because);
}

template <class A, class R>
void walk_response(A& a, R& response) {
  using structures::BlockLoss;
  a.field("times", "s", response.times);
  a.rows("storeys", response.storeys, [&](auto& storey) { walk_storey(a, storey); });
  a.field("roof_displacement", "m", response.roof_displacement);
  walk_envelope(a, "peak_roof_displacement", "m", response.peak_roof_displacement);
  a.field("base_shear", "N", response.base_shear);
  walk_envelope(a, "peak_base_shear", "N", response.peak_base_shear);
  a.field("weight", "N", response.weight);
  a.optional_field("overturning_moment", "N m", response.overturning_moment);
  a.optional_group("peak_overturning_moment",
                   [&] { walk_signed_peaks(a, "N m", response.peak_overturning_moment); });
  a.optional_field("height", "m", response.height);
  a.table("losses", response.losses, [&] {
    a.column("block", "", response.losses, &BlockLoss::block);
    a.column("time", "s", response.losses, &BlockLoss::time);
    a.column("reason", "", response.losses, &BlockLoss::reason);
  });
  a.field("first_loss_of_support", "s", response.first_loss_of_support);
  a.field("fallen_mass_fraction", "1", response.fallen_mass_fraction);
  walk_envelope(a, "peak_base_shear_ratio", "1", response.peak_base_shear_ratio);
  a.field("blocks", "", response.blocks);
  a.group("greatest_lean", [&] {
    a.field("block", "", response.greatest_lean.block);
    a.field("angle", "rad", response.greatest_lean.angle);
    a.field("limit", "rad", response.greatest_lean.limit);
  });
}

template <class A, class S>
void walk_side(A& a, const char* name, S& side) {
  a.group(name, [&] {
    a.field("reach", "m", side.reach);
    a.field("mass", "kg", side.mass);
  });
}

template <class A, class C>
void walk_collapse(A& a, C& collapse) {
  using structures::Fall;
  using structures::Void;
  a.field("mode", "", collapse.mode);
  a.field("reasons", "", collapse.reasons);
  a.field("initiation", "s", collapse.initiation);
  a.field("no_return", "s", collapse.no_return);
  a.field("complete", "s", collapse.complete);
  a.field("first_touch", "s", collapse.first_touch);
  a.group("footprint", [&] {
    a.field("face_left", "m", collapse.footprint.face_left);
    a.field("face_right", "m", collapse.footprint.face_right);
    a.field("foot", "m", collapse.footprint.foot);
    a.field("height", "m", collapse.footprint.height);
    walk_side(a, "left", collapse.footprint.left);
    walk_side(a, "right", collapse.footprint.right);
    a.field("over_the_edge", "", collapse.footprint.over_the_edge);
  });
  a.table("falls", collapse.falls, [&] {
    a.column("block", "", collapse.falls, &Fall::block);
    a.column("support_lost", "s", collapse.falls, &Fall::support_lost);
    a.column("hit", "s", collapse.falls, &Fall::hit);
    a.column("speed", "m/s", collapse.falls, &Fall::speed);
    a.column("energy", "J", collapse.falls, &Fall::energy);
  });
  a.field("impact_energy", "J", collapse.impact_energy);
  a.table("voids", collapse.voids, [&] {
    a.column("area", "m2", collapse.voids, &Void::area);
    a.column("diameter", "m", collapse.voids, &Void::diameter);
    a.column("middle", "m", collapse.voids, &Void::middle);
  });
  a.field("void_area", "m2", collapse.void_area);
  a.field("void_area_before", "m2", collapse.void_area_before);
}

template <class A, class S>
void walk_screening(A& a, S& screening) {
  using structures::CodeCheck;
  a.field("structural_type", "", screening.structural_type);
  a.field("notes", "", screening.notes);
  a.table("checks", screening.checks, [&] {
    a.column("standard", "", screening.checks, &CodeCheck::standard);
    a.column("clause", "", screening.checks, &CodeCheck::clause);
    a.column("subject", "", screening.checks, &CodeCheck::subject);
    a.column("status", "", screening.checks, &CodeCheck::status);
    a.column("limit_name", "", screening.checks, &CodeCheck::limit_name);
    a.column("measure", "", screening.checks, &CodeCheck::measure);
    a.column("limit", "1", screening.checks, &CodeCheck::limit);
    a.column("found", "1", screening.checks, &CodeCheck::found);
    a.column("exceeded", "", screening.checks, &CodeCheck::exceeded);
  });
}

template <class A, class R>
void walk_energy(A& a, R& energy) {
  a.field("input", "J", energy.input);
  a.field("kinetic", "J", energy.kinetic);
  a.field("gravity", "J", energy.gravity);
  a.field("elastic", "J", energy.elastic);
  a.field("friction", "J", energy.friction);
  a.field("damping", "J", energy.damping);
  a.optional_field("fracture", "J", energy.fracture);
  a.field("error", "J", energy.error);
  a.field("largest_input", "J", energy.largest_input);
  a.field("relative_error", "1", energy.relative_error);
  a.field("standing_error", "1", energy.standing_error);
  a.field("input_error", "1", energy.input_error);
}

template <class A, class R>
void walk_numerics(A& a, R& numerics) {
  a.field("integrator", "", numerics.integrator);
  a.field("step", "s", numerics.step);
  a.field("bound", "s", numerics.bound);
  a.field("steps", "", numerics.steps);
  a.field("step_reductions", "", numerics.step_reductions);
  a.field("outcome", "", numerics.outcome);
  a.field("outcome_detail", "", numerics.outcome_detail);
  a.field("end_time", "s", numerics.end_time);
  a.field("asked_time", "s", numerics.asked_time);
  a.field("deepest_overlap", "m", numerics.deepest_overlap);
  a.field("deepest_overlap_ratio", "1", numerics.deepest_overlap_ratio);
  a.field("deepest_overlap_where", "", numerics.deepest_overlap_where);
  a.field("overlap_ratio", "1", numerics.overlap_ratio);
  a.optional_field("mean_overlap_ratio", "1", numerics.mean_overlap_ratio);
  a.field("warnings", "", numerics.warnings);
}

template <class A, class R>
void walk_reproducibility(A& a, R& r) {
  a.field("version", "", r.version);
  a.field("git_hash", "", r.git_hash);
  a.field("compiler", "", r.compiler);
  a.field("command", "", r.command);
  a.field("scenario", "", r.scenario);
  a.field("scenario_sha256", "", r.scenario_sha256);
  a.field("record_sha256", "", r.record_sha256);
  a.field("state_hash", "", r.state_hash);
  a.field("started", "", r.started);
  a.field("wall_seconds", "s", r.wall_seconds);
  a.field("cpu_seconds", "s", r.cpu_seconds);
}

template <class A, class M>
void walk_member(A& a, M& member) {
  a.field("verdict", "", member.verdict);
  a.field("state_hash", "", member.state_hash);
  a.field("values", "", member.values);
  a.field("done", "", member.done);
  a.optional_field("roof_times", "s", member.roof_times);
  a.optional_field("roof_drift", "1", member.roof_drift);
}

template <class A, class E>
void walk_ensemble(A& a, E& ensemble) {
  walk_named_values(a, "perturbations", ensemble.perturbations);
  a.field("metrics", "", ensemble.metrics);
  a.field("units", "", ensemble.units);
  a.rows("members", ensemble.members, [&](auto& member) { walk_member(a, member); });
  a.group("half_step", [&] { walk_member(a, ensemble.half_step); });
}

/// `Run` is a RunResult, const for a writer.
template <class A, class Run>
void walk_run(A& a, Run& run) {
  a.group("verdict", [&] {
    a.field("kind", "", run.verdict.kind);
    a.field("headline", "", run.verdict.headline);
    a.field("evidence", "", run.verdict.evidence);
  });
  a.field("partial", "", run.partial);
  a.group("model", [&] { walk_model(a, run.model); });
  a.group("motion", [&] { walk_motion(a, run.motion); });
  a.group("settle", [&] {
    a.field("settled", "", run.settle.settled);
    a.field("duration", "s", run.settle.duration);
    a.field("greatest_movement", "m", run.settle.greatest_movement);
    a.field("unbalanced_ratio", "1", run.settle.unbalanced_ratio);
  });
  a.optional_group("weight", [&] { walk_weight(a, run.weight_joints); });
  a.optional_group("end", [&] { walk_weight(a, run.end_joints); });
  a.optional_group("joints", [&] { walk_moved_joints(a, run.moved_joints); });
  a.group("trajectory", [&] { walk_trajectory(a, run.trajectory); });
  a.group("response", [&] { walk_response(a, run.response); });
  a.optional_group("collapse", [&] { walk_collapse(a, run.collapse); });
  a.optional_group("screening", [&] { walk_screening(a, run.screening); });
  a.group("energy", [&] { walk_energy(a, run.energy); });
  a.group("numerics", [&] { walk_numerics(a, run.numerics); });
  a.group("reproducibility", [&] { walk_reproducibility(a, run.reproducibility); });
  a.optional_group("ensemble", [&] { walk_ensemble(a, run.ensemble); });
  a.table("moments", run.moments, [&] {
    a.column("time", "s", run.moments, &Moment::time);
    a.column("caption", "", run.moments, &Moment::caption);
  });
}

}  // namespace dougong::app
