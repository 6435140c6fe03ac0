// The model's free choices, and what they do to the numbers of the push, the pull-out and the piston.
#include "app/json/json_reader.h"
#include "app/paper/outcome_table.h"
#include "app/plot/typeset_number.h"
#include "app/studies/figures.h"
#include "core/bodies/contact_law.h"

namespace quicksand {

namespace {

class Choices : public PaperExperiment {
 public:
  void ask_for_runs(PaperJobs& jobs) override {
    const RunGroup samples = jobs.samples();
    const auto push = [&](const std::string& text, const std::string& tag,
                          const ParameterValues& laws) {
      pushes_.push_back({text, jobs.pushes(samples, kForce, tag, laws)});
    };
    push("reference: " + reference_text(jobs), "", {});
    push("residual 1e-6", "residual_1e-6", {{"phases[0].solver_tolerance", 1e-6}});
    push("bonds form during the push", "bonding", {{"phases[0].bonding", true}});
    push("half the rolling friction", "rolling_0.05", {{"contact.rolling_friction", 0.05}});
    push("friction 0.6", "friction_0.6", {{"contact.friction", 0.6}});
    // Effective radius over that of the reference, 2 r_a r_b/(r_a + r_b); grains are equal among themselves.
    const double reference = rolling_length(1, kGrain, kIntruder);
    const ContactLaw law = jobs.jobs()[samples.runs.front()].scenario.grain_law;
    push("rolling at the intruder with the mean of both radii", "rolling_mean",
         at_intruder(law, (kGrain + kIntruder) / 2 / reference));
    push("rolling at the intruder with the smaller radius", "rolling_smaller",
         at_intruder(law, kGrain / reference));

    for (const double force : {jobs.scale().push_forces.front(), kForce}) {
      const RunGroup pushed = jobs.pushes(samples, force);
      for (const double restored : {1.0, 0.5, 0.0})
        pulls_.push_back({force, restored, jobs.pulls(pushed, force, restored)});
    }
    cohesion_ = *jobs.jobs()[pulls_[0].runs.runs[0]].scenario.grain_law.cohesion_force;

    const PistonLoad load;
    const auto press = [&](const std::string& text, const std::string& tag,
                           const PistonLoad& other) {
      pistons_.push_back({text, jobs.pistons(samples, tag, other)});
    };
    press("reference: " + number_text(load.force) + " F_c, rising over " +
              typeset(load.ramp * jobs.scale().height) + " sqrt(d/g), " + number_text(load.mass) +
              " grain masses for the paper's width",
          "", load);
    press("rising three times more slowly", "slow", {.ramp = 3 * load.ramp});
    press("half the force", "half", {.force = load.force / 2});
    press("twice the force", "double", {.force = 2 * load.force});
    press("a tenth of the mass", "light", {.mass = load.mass / 10});
    press("ten times the mass", "heavy", {.mass = load.mass * 10});
  }

  void report(const PaperResults& results, Section& section, Findings&) const override {
    section.add(outcome_table(
        results, "Pushes in the same specimens with the cohesion force and other choices.",
        {"case"}, pushes_, kAfterPush, all_));
    const PaperTargets targets = read_targets(shipped_targets());
    const auto paper = [&](const char* id) { return paper_text(targets.at(id)); };
    section.add(Paragraph{
        "The paper gives an active share of " + paper("penetration.1.0.active_of_contacts") +
        " and a remaining share of " + paper("penetration.1.0.remaining_of_initial") +
        ", with the intruder almost at the bottom."});
    section.add(pull_outcomes(results));
    section.add(Paragraph{"The paper's largest pull-out force is " +
                          paper("penetration.pull_out_over_push") + " times the push force."});
    section.add(outcome_table(results, "The same specimens after the piston, under other loads.",
                              {"case"}, pistons_, kAfterPiston, all_));
    section.add(Paragraph{"The paper gives a volume fraction of " +
                          paper("piston.after.volume_fraction") + ", an active share of " +
                          paper("piston.active_of_contacts") + ", a remaining share of " +
                          paper("piston.remaining_of_initial") + " and a coordination number of " +
                          paper("piston.after.coordination") +
                          ". We do not know the load of the paper's piston. Choices of the "
                          "deposition are compared in "
                          "figure samples, failure criterion and time step in figure break_rule."});
  }

 private:
  static constexpr double kForce = 1;  // [F_c]

  static constexpr double kGrain = 0.5, kIntruder = 1.5;  // radii [d]

  static std::string reference_text(const PaperJobs& jobs) {
    return "energy criterion, dt " + number_text(jobs.scale().push_step) +
           ", max_turn 0.15, residual 1e-5";
  }

  // The law of the grains at the intruder, too, with its rolling friction times `factor`.
  static ParameterValues at_intruder(const ContactLaw& law, double factor) {
    return {{"intruder_contact",
             {{"friction", *law.friction},
              {"rolling_friction", factor * *law.rolling_friction},
              {"cohesion_force", *law.cohesion_force},
              {"cohesion_range", law.cohesion_range / kGrain}}}};
  }

  struct Pull {
    double force;     // of the push before [F_c]
    double restored;  // share of broken bonds [1]
    RunGroup runs;
  };

  Table pull_outcomes(const PaperResults& results) const {
    Table table{
        .caption = "Pull-out for different shares of bonds restored before it, drawn at random.",
        .columns = {{"push force [F_c]", true},
                    {"restored", true},
                    {"pull-out force [F_c]", true},
                    {"pull-out over push", true}}};
    for (const Pull& pull : pulls_)
      table.rows.push_back(
          {{.text = number_text(pull.force)},
           {.text = number_text(pull.restored)},
           cell_of(results.critical_force(pull.runs, cohesion_), all_),
           cell_of(results.critical_force(pull.runs, cohesion_ * pull.force), all_)});
    return table;
  }

  std::vector<OutcomeRow> pushes_, pistons_;
  std::vector<Pull> pulls_;
  double cohesion_ = 1;  // [F_g]
};

}  // namespace

std::unique_ptr<PaperExperiment> make_choices_experiment() { return std::make_unique<Choices>(); }

}  // namespace quicksand
