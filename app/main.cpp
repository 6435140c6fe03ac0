#include <fcntl.h>

#include <csignal>

#include "app/cli/command_line.h"

namespace {

// A file that is opened where a standard stream is closed would receive its text. What is read is empty there,
// what is written fails.
void fill_standard_streams() {
  constexpr int kStandardStreams = 3;
  for (int stream = 0; stream < kStandardStreams; ++stream)
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", O_RDONLY);
}

}  // namespace

int main(int argc, char** argv) {
  fill_standard_streams();
  // A file that a limit of the shell keeps from growing is told like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  return quicksand::run_command_line(argc, argv);
}
