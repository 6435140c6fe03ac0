// The report of finished runs and of recordings: what was modelled, final values, histories over time, pictures, and what
// a reader must be warned of. Several runs stand side by side, with what differs between them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/json/json_text.h"
#include "app/report/report.h"
#include "app/run_report/run_results.h"

namespace quicksand {

// Short names of runs: those of their folders, or whole paths where these are equal.
std::vector<std::string> run_names(std::span<const RunResults> runs);

// Without provenance, which the caller knows. `from`: the phase that time histories begin with, which is their time 0;
// empty: all phases. Throws InputError if a run does not have it.
Report run_report(std::span<const RunResults> runs, const std::string& from = {});

// Its plots: each quantity over time, all runs in one, with the phases of a single run.
std::vector<Figure> run_figures(std::span<const RunResults> runs, const std::string& from = {});

// What its searches found: tables of critical forces and of adiabatic deposits, where there are any.
std::vector<Block> found_by_searches(std::span<const RunResults> runs,
                                     const std::vector<std::string>& names);

// What runs by standard nonsmooth contact dynamics did together.
struct NscdWork {
  std::string sweeps;  // per step: "100", "50 to 100"
  std::int64_t steps = 0, unconverged = 0, broken_in_unconverged = 0;
};

// What a reader of such results must be warned of: a sentence that `opening` begins, and one more.
std::string nscd_warning(const std::string& opening, const NscdWork& work);

// A value of summary.json in a cell of a table; "-" where there is none.
std::string cell_text(const Json& value);

// Unfinished, failed and unconverged computing, and overlaps; a sentence each.
std::vector<std::string> run_warnings(const RunResults& run);

}  // namespace quicksand
