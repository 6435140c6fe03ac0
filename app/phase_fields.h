// The kinds of phases whose fields have a file of their own.
#pragma once

#include "app/fields.h"
#include "core/scenario.h"

namespace quicksand {

void describe_heal(Fields& f, HealPhase& phase);

}  // namespace quicksand
