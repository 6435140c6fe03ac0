// The format of campaign files, described once.
#pragma once

#include "app/campaign/campaign.h"
#include "app/json/fields.h"

namespace quicksand {

void describe_campaign(Fields& f, Campaign& campaign);

}  // namespace quicksand
