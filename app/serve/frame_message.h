// What a browser draws a picture from: bodies, bonds and forces of the present moment, in the units of the world, with
// the colours that render/ gives them.
#pragma once

#include <string>

#include "app/json/json_text.h"
#include "app/session/session.h"

namespace quicksand {

// The session must be loaded. `head` is what else is to be said of the moment.
std::string frame_message(const Session& session, Json head);

// The programs that draw disks and lines, those of the program's own pictures, by their names; a vertex program goes
// behind "vertex_head".
Json shaders_json();

// What the colours mean, for the page's legend; lengths, colours and walls that the drawing needs.
Json look_of(const Session& session);

}  // namespace quicksand
