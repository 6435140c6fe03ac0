// What the searches of a run found: parts of summary.json, and critical_forces.csv and adiabatic.csv with
// the same names as columns. Forces [F_g], lengths [d], intervals [sqrt(d/g)].
#pragma once

#include "app/json/json_text.h"
#include "app/run_folder/run_folder.h"
#include "core/protocol/protocol.h"
#include "core/scene/scenario.h"

namespace quicksand {

// "critical_forces", "adiabatic" (its samples), "adiabatic_unsettled" (finished phases that did not reach their
// tolerance), "shear_strength" (one entry a shear phase) and "drives" (of penetrate and vane phases); a key is left out
// if there is nothing to say under it.
Json search_results(const Scenario& scenario, const ProtocolState& state);

// What a reader of these results (or of a summary that holds them) must know, a sentence each: critical forces
// without a bound, depths without grains in the first `phases_finished` phases, and samples that had not settled.
std::vector<std::string> search_warnings(const Json& results, int phases_finished);

// Whether the greatest force of a critical force's interval that did not move the body held it until rest, rather
// than until max_time. A result without force_held is taken as bracketed.
bool is_bracketed(const Json& critical_force);

// Writes the tables that have rows. Throws InputError.
void write_search_tables(const RunFolder& folder, const ProtocolState& state);

}  // namespace quicksand
