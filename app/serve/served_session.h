// The side that computes: takes what clients say, performs it between two steps, or within one where it changes nothing but
// what is seen, computes while the session runs, and leaves pictures, states and plots for those who serve. Everything in
// here belongs to one thread.
#pragma once

#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>

#include "app/commands/console.h"
#include "app/serve/client_message.h"
#include "app/web/exchange.h"
#include "app/window/interaction_recording.h"
#include "app/window/step_rate.h"
#include "core/base/errors.h"

namespace quicksand {

struct ServedOptions {
  std::filesystem::path folder;  // receives every file
  bool pixels = false;           // pictures are PNG, drawn here
};

class ServedSession {
 public:
  ServedSession(const ServedOptions& options, Exchange& exchange);

  // A command of the user who started the program. Throws InputError, CommandFailure.
  void begin(const Json& command);
  // What there is to do now: messages, a slice of steps, what is to be published. Waits a little if there is nothing.
  void take_turn();
  // Cuts computing short. May be empty.
  std::function<bool()> interrupted;

  // What was done so far, as the text of a session that replays to the same world. A scene must be loaded.
  std::string recording() const;
  Console& console() { return console_; }
  const Console& console() const { return console_; }

 private:
  using Clock = std::chrono::steady_clock;
  // Kept as it came: what it says takes many times as much memory.
  struct Waiting {
    ClientText said;
    bool looks = false, ends_run = false;
  };

  bool listen(const Session& session);
  bool run_is_to_end() const;
  void look_up();
  void take_messages(std::chrono::milliseconds wait);
  void hear(const ClientText& text);
  void perform(ClientId client, const Json& command, const Json& id);
  void answer_next();
  void record(const Json& command, const Json& result);
  void tell_if_full();
  // Whether nothing goes wrong with a scene, a file, a picture or the memory; else every client is told, and the server
  // goes on.
  template <class Do>
  bool succeeds(Do what);
  void compute();
  void play();
  void look_for_samples();
  bool plays() const;
  Json answer_question(const Json& question);
  std::string picture();
  void publish_frame();
  void publish_slow_parts();
  Json state() const;
  Json moment() const;
  void tell(ClientId client, Json answer, const Json& id);
  void tell_problem(ClientId client, const InputError& error, const Json& id);

  ServedOptions options_;
  Exchange& exchange_;
  Console console_;
  InteractionRecording interactions_;
  StepRate rate_;
  std::deque<Waiting> waiting_;
  bool picture_is_old_ = true, state_is_old_ = true, plots_are_old_ = true;
  bool theme_chosen_ = false;  // by a client
  bool told_full_ = false;     // that the recording is
  Clock::time_point last_frame_{}, last_plots_{}, looked_{};
};

}  // namespace quicksand
