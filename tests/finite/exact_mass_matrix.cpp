#include "finite/exact_mass_matrix.hpp"

#include "interpreter/digits50.hpp"
#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline::tests {

using interpreter::Digits50;

struct ExactMassMatrix::Model {
  interpreter::Model<Digits50> model;
};

ExactMassMatrix::ExactMassMatrix(const Robot& robot, const Scene& scene)
    : model_(std::make_unique<const Model>(Model{model_from_robot<Digits50>(robot, scene)})) {}

ExactMassMatrix::~ExactMassMatrix() = default;

bool ExactMassMatrix::is_singular(const std::vector<double>& q) const {
  auto M = interpreter::mass_matrix<Digits50>(model_->model, vector_of<Digits50>(q));
  const interpreter::Vector<Digits50> diagonal = M.diagonal();
  for (Eigen::Index k = 0; k < M.rows(); ++k) {
    if (!(M(k, k) > Digits50(1e-30) * diagonal(k))) return true;
    for (Eigen::Index i = k + 1; i < M.rows(); ++i) {
      const Digits50 factor = M(i, k) / M(k, k);
      for (Eigen::Index j = k; j < M.rows(); ++j) M(i, j) -= factor * M(k, j);
    }
  }
  return false;
}

}  // namespace treeline::tests
