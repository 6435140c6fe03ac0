// What JSON looks like that names or changes a scene.
#pragma once

#include "app/json/fields.h"

namespace quicksand {

constexpr Shape kSceneShape{"the path of a scene file, or a scene {...}",
                            [](const Json& v) { return v.is_object() || v.is_string(); },
                            [] {
                              return Json{{"type", {"string", "object"}}};
                            }};

constexpr Shape kSetShape{"an object of scene paths with their values",
                          [](const Json& v) { return v.is_object() && !v.empty(); },
                          [] {
                            return Json{{"type", "object"}, {"minProperties", 1}};
                          }};

}  // namespace quicksand
