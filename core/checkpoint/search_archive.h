// The searches of a protocol in a checkpoint, without their base world.
#pragma once

#include "core/checkpoint/archive.h"
#include "core/protocol/protocol.h"

namespace quicksand {

template <class Archive, class Search>
void describe_present_search(Archive& archive, Search& search) {
  archive.word("kind", search.kind);
  archive.value("trial_runs", search.trial_runs);
  archive.list("targets", search.targets, [](auto& a, auto& target) {
    a.value("body", target.body);
    a.value("depth", target.depth);
    a.value("weight_above", target.weight_above);
  });
  archive.value("finished", search.finished);
  archive.value("trial", search.trial);
  archive.value("force", search.force);
  archive.value("first", search.bracket.first);
  archive.value("low", search.bracket.low);
  archive.optional("high", search.bracket.high);
  archive.added("held", search.bracket.held);
  archive.value("trials", search.bracket.trials);
  archive.value("undecided", search.undecided);
  archive.value("interval", search.interval);
  archive.added("breaks", search.breaks);
  archive.added("last_break", search.last_break);
}

template <class Archive, class State>
void describe_search_results(Archive& archive, State& state) {
  archive.list("critical_forces", state.critical_forces, [](auto& a, auto& found) {
    a.value("phase", found.phase);
    a.word("kind", found.kind);
    a.value("body", found.body);
    a.value("x", found.position.x());
    a.value("y", found.position.y());
    a.value("depth", found.depth);
    a.value("weight_above", found.weight_above);
    a.value("force_low", found.force_low);
    a.optional("force_high", found.force_high);
    a.added("force_held", found.force_held);
    a.value("trials", found.trials);
    a.value("undecided", found.undecided);
  });
  archive.list("adiabatic_deposits", state.adiabatic_deposits, [](auto& a, auto& sample) {
    a.value("phase", sample.phase);
    a.value("interval", sample.interval);
    a.value("volume_fraction", sample.volume_fraction);
    a.value("coordination", sample.coordination);
    a.value("grains", sample.grains);
    a.optional("change", sample.change);
  });
  if (!archive.has("drive_results", true)) return;  // of an earlier version
  archive.list("drive_results", state.drive_results, [](auto& a, auto& found) {
    a.value("phase", found.phase);
    a.word("drive", found.drive);
    a.optional("peak", found.peak);
    a.optional("peak_at", found.peak_at);
    a.optional("residual", found.residual);
    a.optional("mean", found.mean);
    a.value("way", found.way);
    a.value("radius", found.radius);
    a.value("cleared", found.cleared);
    if (!a.has("normal_load", found.normal_load.has_value())) return;
    a.optional("normal_load", found.normal_load);
    a.optional("inertial_number", found.inertial_number);
  });
}

// Reading throws std::exception for what is no search.
template <class Archive, class State>
void describe_search(Archive& archive, State& state) {
  describe_present_search(archive, state.search);
  describe_search_results(archive, state);
}

}  // namespace quicksand
