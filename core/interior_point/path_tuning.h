// The constants of the path of the interior point, each with what fixes it.
#pragma once

namespace quicksand {

struct PathTuning {
  // Proximal term over the contact's Delassus diagonal. The digits of the smallest pivot bound it below, about
  // 1e-16/1e-7 of the others left, the error that it may make in a step above: over a whole ploughing run 1e-9 leaves
  // one step in six unconverged, 1e-8 to 1e-6 one in a thousand.
  static constexpr double kProximal = 1e-7;
  // Where the path folds the term is raised to this for one step. Of 65 solutions of a collapse of 4800 grains, five
  // fail with at most 1e-4.
  static constexpr double kProximalAtFolds = 1e-3;
  // Share of the way to the boundary that a step may go, as usual in primal-dual methods [Mehrotra 1992].
  static constexpr double kBoundaryShare = 0.995;
  // A step shorter than this is not taken; the products are aligned instead, at this share of their mean.
  static constexpr double kShortStep = 0.3, kAlignedShare = 0.5;
  // A step that would be shorter than `kLongStep` is looked for once more, with the products kept within these shares
  // of what is aimed at where a step longer by `kFurther` would bring them [Gondzio 1996]. Repeating it gains little.
  static constexpr double kLongStep = 0.95, kFurther = 0.3, kLeastOfAim = 0.1, kMostOfAim = 10;
  // Beyond a fold of the path, products aim at this many times their mean.
  static constexpr double kGrowth = 20;
  // Iterations after acceptance in which velocities may settle.
  static constexpr int kSettling = 3;
  // Iterations of Newton's method on the modes that end a solution: with the right modes the first makes it exact, the
  // second is for those that the first has changed.
  static constexpr int kNewtonSteps = 2;
  // A path that is this long and comes within the distance `kNear` goes on for the sake of some contacts that are still
  // undecided, once velocities have settled: so few sweeps are tried from there.
  static constexpr double kNear = 30;
  static constexpr int kLongPath = 8, kFewSweeps = 8;
};

}  // namespace quicksand
