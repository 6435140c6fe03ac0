// The session in a browser: the same commands, by hand, from anywhere.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "app/serve/served_session.h"

namespace quicksand {

struct ServeOptions {
  std::string
      file;  // a scene, by name or path, a session that is played first, or the folder of a run; empty: the demo
  std::filesystem::path out;     // empty: out/serve
  std::filesystem::path record;  // receives what was done, as a session file; empty: none
  std::filesystem::path
      token_file;  // that keeps the token from one start to the next; empty: a new one each time
  std::string address = "127.0.0.1";
  std::string host;     // by which browsers call the server besides its address
  int port = 7878;      // 0: any that is free
  bool open = false;    // in the browser of this machine
  bool pixels = false;  // sends pictures instead of shapes
};

// Lets the session compute and answer, and writes what was done to `record`, unless that is empty: also where an error
// ends it, which is thrown on.
void serve_until(const std::function<bool()>& ended, ServedSession& live,
                 const std::filesystem::path& record);

// Returns the exit code after Ctrl-C. Throws InputError.
int run_serve(const ServeOptions& options);

}  // namespace quicksand
