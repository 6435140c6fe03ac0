// The report of a campaign: its numbers over its parameters with standard errors over the realizations.
#pragma once

#include <filesystem>

#include "app/campaign/campaign.h"
#include "app/report/report.h"

namespace quicksand {

// A folder that `campaign` has filled, finished or not.
bool is_campaign(const std::filesystem::path& folder);

// Without provenance, which the caller knows. Adds the computing time of its runs to `seconds`. Throws InputError if
// the campaign's file cannot be read, or what its report is to show is not there.
Report campaign_report(const std::filesystem::path& folder, double& seconds);

}  // namespace quicksand
