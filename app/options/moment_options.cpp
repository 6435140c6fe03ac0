#include "app/options/moment_options.h"

#include <algorithm>
#include <string>

#include "app/options/number_range.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr double kLongestTime = 1e12;   // [sqrt(d/g)]
constexpr double kRounding = 1e-9;      // times are sums of steps
constexpr double kLikeWritten = 0.005;  // pictures round times to two digits [sqrt(d/g)]

void require_reached(const History& history, const char* option, double time) {
  const double first = history.moments().front().time, last = history.moments().back().time;
  const double slack = std::max(kLikeWritten, kRounding * last);
  if (time >= first - slack && time <= last + slack) return;
  throw InputError(std::string(option) + " " + message_number(time),
                   "must be a number from " + message_number(first) + " to " +
                       message_number(last) + " sqrt(d/g), the times in " +
                       history.path().string());
}

}  // namespace

void add_moment_options(CLI::App& command, MomentOptions& options) {
  const auto time = in_range(between(0, kLongestTime, "sqrt(d/g)"));
  command
      .add_option("--from", options.from,
                  "start at this time of the history [sqrt(d/g)]; its beginning if absent")
      ->type_name("TIME")
      ->check(time);
  command.add_option("--to", options.to, "end at this time [sqrt(d/g)]; its end if absent")
      ->type_name("TIME")
      ->check(time);
}

std::size_t moment_at(const History& history, const char* option, double time) {
  require_reached(history, option, time);
  return history.nearest(time);
}

Moments moments_between(const History& history, const MomentOptions& options) {
  if (options.from && options.to && *options.from > *options.to)
    throw InputError(
        "--from " + message_number(*options.from) + " --to " + message_number(*options.to),
        "is an empty interval: it begins after its end");
  const std::vector<Moment>& all = history.moments();
  Moments found{0, all.size()};
  if (options.from) {
    require_reached(history, "--from", *options.from);
    const auto first = std::ranges::lower_bound(all, *options.from - kRounding, {}, &Moment::time);
    found.first = static_cast<std::size_t>(first - all.begin());
  }
  if (options.to) {
    require_reached(history, "--to", *options.to);
    const auto end = std::ranges::upper_bound(all, *options.to + kRounding, {}, &Moment::time);
    found.end = static_cast<std::size_t>(end - all.begin());
  }
  if (found.first < found.end) return found;
  throw InputError("--from " + message_number(options.from.value_or(all.front().time)) + " --to " +
                       message_number(options.to.value_or(all.back().time)),
                   "has no sample between them; the nearest is at " +
                       message_number(all[history.nearest(options.from.value_or(0))].time));
}

}  // namespace quicksand
