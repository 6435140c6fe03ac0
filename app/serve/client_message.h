// What a client says: a command of the vocabulary of sessions that it may give, or a question.
#pragma once

#include <string_view>

#include "app/json/json_text.h"

namespace quicksand {

struct ClientMessage {
  Json command;   // {"command": NAME, ...}; null if it is a question
  Json question;  // {"ask": NAME, ...}
};

// Throws InputError if the text is neither, if the command does not exist or has other arguments, or if it would read or
// write beyond the folder of the run: a client names shipped scenes and files of that folder. `id` receives that of the
// message, which goes back with the answer, whatever else is wrong with it; null if there is none.
ClientMessage read_message(std::string_view text, Json& id);

}  // namespace quicksand
