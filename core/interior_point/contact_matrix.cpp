#include "core/interior_point/contact_matrix.h"

#include "core/base/parallel.h"

namespace quicksand {

namespace {

// What a contact adds to the blocks of its bodies: X^T D Y, up to a sign, where X and Y take the motion of a body to
// that of its contact point, [R s; 0 1] with the rows n and t of R and s the velocity there of a unit spin. Of D only
// the first column and the diagonal are not zero (see interior_point_cone.h). Directions in which a body cannot move
// are left out.
class ContactBlocks {
 public:
  ContactBlocks(const ContactProblem& problem, const ContactRow& row, const Mat3& d)
      : row_(row),
        d_(d),
        inverse_mass_a_(problem.inverse_mass[row.a]),
        inverse_mass_b_(problem.inverse_mass[row.b]),
        held_((inverse_mass_a_.array() == 0).any() || (inverse_mass_b_.array() == 0).any()) {
    const Vec2 n = row.normal, t = perpendicular(n);
    const Vec2 along_n = d(0, 0) * n + d(1, 0) * t, along_t = d(1, 1) * t;
    xx_ = along_n.x() * n.x() + along_t.x() * t.x();
    yx_ = along_n.y() * n.x() + along_t.y() * t.x();
    xy_ = along_n.x() * n.y() + along_t.x() * t.y();
    yy_ = along_n.y() * n.y() + along_t.y() * t.y();
  }
  void add_aa(const BlockLu::Entry& sum) const {
    add(1, row_.spin_a, row_.spin_a, inverse_mass_a_, inverse_mass_a_, sum);
  }
  void add_bb(const BlockLu::Entry& sum) const {
    add(1, row_.spin_b, row_.spin_b, inverse_mass_b_, inverse_mass_b_, sum);
  }
  void add_ab(const BlockLu::Entry& sum) const {
    add(-1, row_.spin_a, row_.spin_b, inverse_mass_a_, inverse_mass_b_, sum);
  }
  void add_ba(const BlockLu::Entry& sum) const {
    add(-1, row_.spin_b, row_.spin_a, inverse_mass_b_, inverse_mass_a_, sum);
  }

 private:
  [[gnu::always_inline]] void add(double sign, const Vec2& x, const Vec2& y,
                                  const Vec3& inverse_mass_x, const Vec3& inverse_mass_y,
                                  BlockLu::Entry sum) const {
    const Vec2 n = row_.normal, t = perpendicular(n);
    const Vec2 turned(d_(0, 0) * y.x(),
                      d_(1, 0) * y.x() + d_(1, 1) * y.y());  // by a unit spin of y
    const Vec2 torque(x.x() * d_(0, 0) + x.y() * d_(1, 0) + d_(2, 0), x.y() * d_(1, 1));
    Mat3 block;
    block << xx_, xy_, turned.x() * n.x() + turned.y() * t.x(),  //
        yx_, yy_, turned.x() * n.y() + turned.y() * t.y(),       //
        torque.x() * n.x() + torque.y() * t.x(), torque.x() * n.y() + torque.y() * t.y(),
        x.dot(turned) + d_(2, 0) * y.x() + d_(2, 2);
    if (held_)
      for (int k = 0; k < 3; ++k) {
        if (inverse_mass_x[k] == 0) block.row(k).setZero();
        if (inverse_mass_y[k] == 0) block.col(k).setZero();
      }
    sum += sign * block;
  }

  const ContactRow& row_;
  const Mat3& d_;
  const Vec3 &inverse_mass_a_, &inverse_mass_b_;
  const bool held_;
  double xx_ = 0, xy_ = 0, yx_ = 0, yy_ = 0;  // R^T D R
};

}  // namespace

void ContactMatrix::attach(const ContactProblem& problem) {
  problem_ = &problem;
  body_of_row_.clear();
  row_of_body_.assign(problem.inverse_mass.size(), -1);
  for (std::size_t i = 0; i < problem.inverse_mass.size(); ++i) {
    if (problem.inverse_mass[i].isZero(0)) continue;
    row_of_body_[i] = static_cast<int>(body_of_row_.size());
    body_of_row_.push_back(static_cast<int>(i));
  }
  edges_.clear();
  edge_of_contact_.assign(problem.contacts.size(), -1);
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const int i = row_of_body_[problem.contacts[c].a], j = row_of_body_[problem.contacts[c].b];
    if (i < 0 || j < 0) continue;
    edge_of_contact_[c] = static_cast<int>(edges_.size());
    edges_.push_back({i, j});
  }
  lu_.analyse(static_cast<int>(body_of_row_.size()), edges_);
}

void ContactMatrix::factorise(const std::vector<Mat3>& impedance) {
  const ContactProblem& problem = *problem_;
  lu_.clear();
  for (std::size_t k = 0; k < body_of_row_.size(); ++k) {
    const Vec3& im = problem.inverse_mass[body_of_row_[k]];
    for (int d = 0; d < 3; ++d) lu_.diagonal(static_cast<int>(k))(d, d) = im[d] > 0 ? 1 / im[d] : 1;
  }
  visit_sides(
      problem,
      [&](std::size_t c, const ContactRow& row) {
        const ContactBlocks blocks(problem, row, impedance[c]);
        const int i = row_of_body_[row.a], e = edge_of_contact_[c];
        if (i >= 0) blocks.add_aa(lu_.diagonal(i));
        if (e >= 0) blocks.add_ba(lu_.lower(e));
      },
      [&](std::size_t c, const ContactRow& row) {
        const ContactBlocks blocks(problem, row, impedance[c]);
        const int j = row_of_body_[row.b], e = edge_of_contact_[c];
        if (j >= 0) blocks.add_bb(lu_.diagonal(j));
        if (e >= 0) blocks.add_ab(lu_.upper(e));
      });
  lu_.factorise();
}

void ContactMatrix::velocity_change(const std::vector<Vec3>& impulse, std::vector<Vec3>& dv) {
  const ContactProblem& problem = *problem_;
  dv.assign(problem.inverse_mass.size(), Vec3::Zero());
  visit_sides(
      problem,
      [&](std::size_t c, const ContactRow& row) { dv[row.a] += momentum_of_a(row, impulse[c]); },
      [&](std::size_t c, const ContactRow& row) { dv[row.b] += momentum_of_b(row, impulse[c]); });
  right_hand_side_.resize(body_of_row_.size());
  for (std::size_t k = 0; k < body_of_row_.size(); ++k) {
    const int i = body_of_row_[k];
    for (int d = 0; d < 3; ++d)
      right_hand_side_[k][d] = problem.inverse_mass[i][d] > 0 ? dv[i][d] : 0;
  }
  lu_.solve(right_hand_side_);
  for (std::size_t i = 0; i < dv.size(); ++i) {
    const int k = row_of_body_[i];
    dv[i] = k < 0 ? Vec3(0, 0, 0) : right_hand_side_[static_cast<std::size_t>(k)];
  }
}

}  // namespace quicksand
