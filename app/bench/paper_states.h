// The states that are measured: the paper's system while it is deposited, settled and ploughed.
//
// They take minutes to prepare, so they are kept as checkpoints in the folder of the results and taken
// from there while program version and scene are the same. They do not depend on the method that is
// measured: all methods see the same problems.
#pragma once

#include "app/bench/bench.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/scenario.h"

namespace quicksand::bench {

// Deposit of `grains`, settling, and a push at dt = 1e-3; else as assets/scenes/paper_intruder.json,
// but for the number of grains instead of the height. Solved by `method`.
Scenario paper_scene(const Options& options, const std::string& method);

// The scene as it is prepared: by the method "auto".
inline Scenario paper_scene(const Options& options) { return paper_scene(options, "auto"); }

// Right after the last grain.
Checkpoint deposited(const Options& options);
// Stores a deposition that was made anyhow as that state.
void keep_deposited(const Options& options, Checkpoint made);
// After the settling phase of the scene, which lasts 3 sqrt(d/g) at most.
Checkpoint settled(const Options& options);
// The paper's scene in a box eight times as wide.
Scenario wide_scene(const Options& options);
// As many grains in that box, deposited at the same rate for its width, and settled
// until nothing moves faster than 1e-3 sqrt(g d) for 0.5 sqrt(d/g). The paper's box will not do: filled one
// grain a step, its packing slumps with a median speed of 0.43 sqrt(g d) 3 sqrt(d/g) after the last
// grain, and is not at rest after 20 more.
Checkpoint at_rest(const Options& options);
// The intruder half-way down.
Checkpoint ploughing(const Options& options);

// The settled packing with a piston on its top; contacts made from now on are plain.
World under_piston(const Options& options);
// What follows, at dt = 5e-3, until 20 sqrt(d/g) have passed.
Scenario piston_scene(const Options& options, const std::string& method);

// The shipped collapse (quick: in a box of half its size) 1 sqrt(d/g) after its push, while the channel falls in.
Checkpoint collapsing(const Options& options);
// Grains without cohesion (assets/scenes/dense.json; quick: 100 of them) 1 sqrt(d/g) after the last was dropped.
Checkpoint dense(const Options& options);

// A deposit without dynamics: every grain stays where it first touched, in a box of the paper's shape,
// with bonds and without forces.
World fresh_deposit(const Options& options, std::int64_t grains);

// Their scenes.
Scenario collapse_scene(const Options& options);
Scenario dense_scene(const Options& options);

}  // namespace quicksand::bench
