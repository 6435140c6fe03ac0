// The constants of the path of the interior point, each with what fixes it.
#pragma once

namespace quicksand {

struct PathTuning {
  // Proximal term over the contact's Delassus diagonal. The digits of the smallest pivot bound it below, about
  // 1e-16/1e-7 of the others left, the error that it may make in a step above: over a whole ploughing run 1e-9 leaves
  // one step in six unconverged, 1e-8 to 1e-6 one in a thousand.
  static constexpr double kProximal = 1e-7;
  // Where the path folds the term is raised to this, and beyond multiplied by the decay in each iteration: it slows
  // the end of the path. Of 65 solutions of a collapse of 4800 grains, five fail with at most 1e-4.
  static constexpr double kProximalAtFolds = 1e-3, kProximalDecay = 0.5;
  // Share of the way to the boundary that a step may go, as usual in primal-dual methods [Mehrotra 1992].
  static constexpr double kBoundaryShare = 0.995;
  // Products below this share of what the tolerances ask for are rounding, and are not aimed at.
  static constexpr double kLeastProduct = 0.05;
  // A step shorter than this is not taken; the products are aligned instead, at this share of their mean.
  static constexpr double kShortStep = 0.3, kAlignedShare = 0.5;
  // A step that would be shorter than `kLongStep` is looked for once more, with the products kept within these shares
  // of what is aimed at where a step longer by `kFurther` would bring them [Gondzio 1996]. Repeating it gains little.
  static constexpr double kLongStep = 0.95, kFurther = 0.3, kLeastOfAim = 0.1, kMostOfAim = 10;
  // Beyond a fold of the path, products aim at this many times their mean.
  static constexpr double kGrowth = 20;
  // No product may fall below this share of the mean: one pair at the boundary would block all others.
  static constexpr double kLeastShare = 1e-4;
  // Iterations after acceptance in which velocities may settle.
  static constexpr int kSettling = 3;
  // Iterations of Newton's method on the modes that end a solution: with the right modes one makes it exact,
  // more may find them where velocities have not settled.
  static constexpr int kFinishing = 1, kSearching = 3;
  // Where within the distance `kNear` so many factorisations gain less than the factor `kGain` the path has jammed, and
  // so many sweeps of relaxation, which cost less, are tried from the best state. 62 solutions under a piston are as
  // much work where that begins within 300, after 5 factorisations. A path whose velocities have not settled has
  // hardly begun: in debris that comes to rest the first eight steps are short, and what relaxation ends there is in
  // free fall.
  static constexpr double kNear = 30, kGain = 0.8;
  static constexpr int kPatience = 8, kTrySweeps = 100;
  // A path that is this long and comes within `kNear` goes on for the sake of some contacts that are still undecided,
  // as far as velocities have settled to this share of their tolerance: so few sweeps are tried from there. 51
  // solutions of a collapse of 4900 grains take 11.7 factorisations for 21.6; errors of their velocities are 0.4 % of
  // the mean velocity for 0.15 %.
  static constexpr int kLongPath = 8, kFewSweeps = 8;
  static constexpr double kSettledShare = 0.1;
};

}  // namespace quicksand
