// The paper's programme at a small scale, and runs that are as if they had been made.
#pragma once

#include <string>

#include "app/paper/paper_jobs.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/whole_file.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {

class PaperFixture : public ProgramFixture {
 protected:
  PaperScale small() const {
    PaperScale scale = quick_scale();
    scale.width = 12;
    scale.height = 20;
    return scale;
  }
  // As a run that finished leaves it.
  static void leave_results(const Job& job, const Json& summary,
                            const std::string& series = "time,step,phase\n0,0,push\n") {
    std::filesystem::create_directories(job.folder.path);
    write_whole(job.folder.scene(), to_text(job.scenario));
    write_whole(job.folder.series(), series);
    Json all = summary;
    all["finished"] = true;
    all["version"] = "0";
    write_whole(job.folder.summary(), all.dump());
  }
};

}  // namespace quicksand::test
