#include <array>

#include "app/base/interrupt.h"
#include "app/bench/bench.h"

namespace quicksand::bench {

std::span<const Part> parts() {
  static const std::array all{
      Part{"precision", "Work against precision of one step",
           "time to a residual and to a velocity error, for every solver on the same problems",
           precision_tasks, report_precision},
      Part{"hard", "Hard cases", "problems with known answers on which solvers fail", hard_tasks,
           report_hard},
      Part{"error", "Error of a run against its cost",
           "observables of a run against time step, tolerance and failure criterion", error_tasks,
           report_error},
      Part{"size", "Cost against size", "seconds and bytes per disk, from 1000 disks up",
           size_tasks, report_size},
      Part{"terms", "Cost of the model's terms", "time that a scene saves by leaving out a term",
           term_tasks, report_terms},
      Part{"shapes", "Cost of bodies of several parts",
           "time of a step with a vane compared with a disk of equal area", shape_tasks,
           report_shapes},
      Part{"goals", "Goals", "the solver's speed against its goals at full size", goal_tasks,
           report_goals},
      Part{"kernels", "Distance from the machine's limits",
           "operations and bytes per second of a step's kernels against the machine's peak and "
           "bandwidth",
           kernel_tasks, report_kernels},
      Part{"threads", "Thread scaling",
           "time of a solution on one core and on several, with identical results", thread_tasks,
           report_threads},
      Part{"nscd", "Standard nonsmooth contact dynamics",
           "time to update a contact, and sweeps needed by a chain", nscd_tasks, report_nscd},
      Part{"problems", "Recorded problems",
           "contact problems recorded in runs, solved again: median, worst, errors", problem_tasks,
           report_problems, false},
      Part{"serve", "A run in a browser",
           "cost of `serve` clients to a run, and the delay until they see what they ask for",
           serve_tasks, report_serve, false},
      Part{"peers", "Other programs", "the same scenes in Box2D, Yade and Siconos, where installed",
           peer_tasks, report_peers, false}};
  return all;
}

void stop_if_interrupted() {
  if (InterruptWatch().interrupted()) throw Interrupted();
}

}  // namespace quicksand::bench
