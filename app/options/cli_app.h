// The parser of the command line by its name alone: its header is the slowest of all to read, and stays in the sources
// that use it.
#pragma once

// NOLINTNEXTLINE(readability-identifier-naming): the library's name
namespace CLI {
class App;
}
