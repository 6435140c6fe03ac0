// The format of campaign files, described once.
#pragma once

#include "app/campaign.h"
#include "app/fields.h"

namespace quicksand {

void describe_campaign(Fields& f, Campaign& campaign);

}  // namespace quicksand
