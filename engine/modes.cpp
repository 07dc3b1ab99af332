#include "engine/modes.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace dougong::engine {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Derivative of the relative displacement along `direction` at the contact point, with respect to
// (x, y, angle) of the corner's body, then of the edge's.
Vector6 jacobian(Vec2 direction, const PointGeometry& g) {
  Vector6 j;
  j << direction.x, direction.y, cross(g.arm_corner, direction), -direction.x, -direction.y,
      -cross(g.arm_edge, direction);
  return j;
}

// Second derivatives of g = n . (p - e): n turns with the edge's body, p with the corner's.
Matrix6 gap_curvature(const PointGeometry& g) {
  const Vec2 t = turned(g.normal);
  const double corner = dot(g.normal, g.arm_corner), edge = dot(g.normal, g.arm_edge);
  Matrix6 h = Matrix6::Zero();
  h(0, 5) = h(5, 0) = t.x;
  h(1, 5) = h(5, 1) = t.y;
  h(3, 5) = h(5, 3) = -t.x;
  h(4, 5) = h(5, 4) = -t.y;
  h(2, 2) = -corner;
  h(2, 5) = h(5, 2) = corner;
  h(5, 5) = -edge;
  return h;
}

Matrix6 point_tangent(const PointStiffness& law, const PointGeometry& g) {
  const Vector6 jn = jacobian(g.normal, g), jt = jacobian(turned(g.normal), g);
  const double tangential = law.friction > 0.0 ? law.tangential : 0.0;
  return law.normal * jn * jn.transpose() - law.normal * g.overlap * gap_curvature(g) +
         tangential * jt * jt.transpose();
}

void scatter(const Model& model, Index corner, Index edge, const Matrix6& k,
             std::vector<Eigen::Triplet<double>>& entries) {
  const std::size_t n = model.body_count;
  const Index owner[6] = {corner, corner, corner, edge, edge, edge};
  for (int r = 0; r < 6; ++r)
    for (int c = 0; c < 6; ++c) {
      if (model.is_terrain(owner[r]) || model.is_terrain(owner[c])) continue;
      entries.emplace_back(static_cast<int>(static_cast<std::size_t>(r % 3) * n + owner[r]),
                           static_cast<int>(static_cast<std::size_t>(c % 3) * n + owner[c]), k(r, c));
    }
}

Eigen::VectorXd mass_diagonal(const Model& model) {
  const auto n = static_cast<Eigen::Index>(model.body_count);
  Eigen::VectorXd m(3 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    m[i] = m[n + i] = model.mass[static_cast<std::size_t>(i)];
    m[2 * n + i] = model.inertia[static_cast<std::size_t>(i)];
  }
  return m;
}

// Lanczos on A = (K + shift M)^-1 M, orthogonal in the M product, with full reorthogonalisation.
struct Krylov {
  Eigen::MatrixXd basis;
  Eigen::MatrixXd projected;
};

Krylov lanczos(const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>& factor, const Eigen::VectorXd& mass,
               Eigen::VectorXd start, Eigen::Index steps) {
  Krylov k{Eigen::MatrixXd(mass.size(), steps), Eigen::MatrixXd::Zero(steps, steps)};
  Eigen::Index size = 0;
  for (; size < steps; ++size) {
    for (int pass = 0; pass < 2; ++pass)
      start -= k.basis.leftCols(size) * (k.basis.leftCols(size).transpose() * mass.cwiseProduct(start));
    const double length = std::sqrt(start.dot(mass.cwiseProduct(start)));
    if (!(length > 1e-10) || !std::isfinite(length)) break;
    k.basis.col(size) = start / length;
    start = factor.solve(mass.cwiseProduct(k.basis.col(size)));
    const Eigen::VectorXd column = k.basis.leftCols(size + 1).transpose() * mass.cwiseProduct(start);
    k.projected.col(size).head(size + 1) = column;
    k.projected.row(size).head(size + 1) = column.transpose();
    start /= std::max(1e-300, start.norm());
  }
  k.basis.conservativeResize(Eigen::NoChange, size);
  k.projected.conservativeResize(size, size);
  return k;
}

// Bonds as points too: b's anchor is the corner, a's face the edge.
Matrix6 bond_tangent(const BondPoint& p, const BondHistory& history, const BondGeometry& b) {
  PointGeometry g;
  g.normal = b.normal, g.arm_corner = b.arm_b, g.arm_edge = b.arm_a;
  const double e = b.opening - history.relaxed();
  if (history.gone() || (history.broken && e > 0.0)) return Matrix6::Zero();
  const double closed = history.joined ? p.law.normal : 0.0;
  const double k = e > 0.0 ? softened_tension(p.law, e, std::max(e, history.widest)) / e : closed;
  const Vector6 jn = jacobian(g.normal, g), jt = jacobian(turned(g.normal), g);
  return k * jn * jn.transpose() + k * e * gap_curvature(g) + p.law.tangential * jt * jt.transpose();
}

// V(u), u the separation: K = k_along J J' + k_across J J' + F . d2u, d2u/dtheta2 = arms towards the
// centroids.
Matrix6 joint_tangent(const JointElement& j, const JointGeometry& g) {
  PointGeometry p;
  p.arm_corner = g.arm_b, p.arm_edge = g.arm_a;
  const double length = norm(g.separation);
  const Vec2 along = j.axial() && length > 0.0 ? (1.0 / length) * g.separation : Vec2{1.0, 0.0};
  const double across = !j.axial() ? j.stiffness : length > 0.0 ? dot(g.spring, along) / length : 0.0;
  const Vector6 ja = jacobian(along, p), jc = jacobian(turned(along), p);
  Matrix6 k = j.stiffness * ja * ja.transpose() + across * jc * jc.transpose();
  k(2, 2) -= dot(g.spring, g.arm_b);
  k(5, 5) += dot(g.spring, g.arm_a);
  Vector6 turn = Vector6::Zero();
  turn[2] = 1.0, turn[5] = -1.0;
  return k + j.rotational_stiffness * turn * turn.transpose();
}

void scatter_links(const Model& model, const State& state, std::span<const Frame> frames,
                   std::vector<Eigen::Triplet<double>>& entries) {
  for (std::size_t i = 0; i < model.bond_points.size(); ++i) {
    const BondPoint& p = model.bond_points[i];
    scatter(model, p.b, p.a, bond_tangent(p, state.bonds.history[i], bond_geometry(p, frames)), entries);
  }
  for (const JointElement& j : model.joints)
    scatter(model, j.b, j.a, joint_tangent(j, joint_geometry(j, frames)), entries);
}

Mode make_mode(const Eigen::VectorXd& shape, double omega_squared, const Eigen::VectorXd& mass,
               double total_mass) {
  const auto n = mass.size() / 3;
  const double excitation = mass.head(n).dot(shape.head(n));
  Mode mode;
  mode.angular_frequency_squared = omega_squared;
  mode.participation = excitation * excitation / total_mass;
  mode.shape.assign(shape.data(), shape.data() + shape.size());
  return mode;
}

}  // namespace

double Mode::period() const {
  return angular_frequency_squared > 0.0 ? 2.0 * std::numbers::pi / std::sqrt(angular_frequency_squared)
                                         : 0.0;
}

Eigen::SparseMatrix<double> tangent_stiffness(const Model& model, const State& state) {
  const auto frames = frames_of(model, state);
  const ContactPoints& points = state.contacts.points;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointGeometry g = geometry_of(points, i, frames);
    if (g.overlap > 0.0)
      scatter(model, points.corner_body[i], points.edge_body[i], point_tangent(points.stiffness(i), g),
              entries);
  }
  scatter_links(model, state, frames, entries);
  const auto size = static_cast<Eigen::Index>(3 * model.body_count);
  Eigen::SparseMatrix<double> k(size, size);
  k.setFromTriplets(entries.begin(), entries.end());
  return k;
}

std::vector<Mode> horizontal_modes(const Model& model, const State& state, std::size_t count) {
  if (model.body_count == 0) return {};
  const Eigen::VectorXd mass = mass_diagonal(model);
  const auto n = static_cast<Eigen::Index>(model.body_count);
  Eigen::SparseMatrix<double> shifted = tangent_stiffness(model, state);
  // Free bodies have no stiffness at all: a shift of (0.1 rad/s)^2 keeps the factorisation regular.
  const double shift = 0.01;
  for (Eigen::Index i = 0; i < 3 * n; ++i) shifted.coeffRef(i, i) += shift * mass[i];
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(shifted);
  if (factor.info() != Eigen::Success) return {};

  Eigen::VectorXd start = Eigen::VectorXd::Zero(3 * n);
  start.head(n).setOnes();
  const Krylov krylov =
      lanczos(factor, mass, factor.solve(mass.cwiseProduct(start)), std::min<Eigen::Index>(3 * n, 40));
  if (krylov.basis.cols() == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(krylov.projected);
  std::vector<Mode> modes;
  for (Eigen::Index j = 0; j < ritz.eigenvalues().size(); ++j) {
    const double inverse = ritz.eigenvalues()[j];
    if (std::abs(inverse) < 1e-14) continue;
    modes.push_back(make_mode(krylov.basis * ritz.eigenvectors().col(j), 1.0 / inverse - shift, mass,
                              model.total_mass()));
  }
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) {
    return a.angular_frequency_squared < b.angular_frequency_squared;
  });
  if (modes.size() > count) modes.resize(count);
  return modes;
}

}  // namespace dougong::engine
