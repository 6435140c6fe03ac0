// quicksand compare: whether two pictures look the same.
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/options/number_range.h"
#include "app/options/picture_options.h"
#include "app/view/image_comparison.h"
#include "core/base/errors.h"
#include "render/image/png.h"

namespace quicksand {

namespace {

struct CompareArguments {
  std::filesystem::path ours, reference, difference;
  int tolerance = kSameLook;
};

void check_difference(const CompareArguments& options) {
  const std::filesystem::path& out = options.difference;
  if (out.empty()) return;
  require_png(out);
  for (const auto& read : {options.ours, options.reference})
    if (std::error_code ignored; std::filesystem::equivalent(read, out, ignored))
      throw InputError("--difference " + out.string(),
                       "is one of the pictures to compare; choose another file");
}

int compare(const CompareArguments& options) {
  check_difference(options);
  const ImageComparison result = compare_images(options.ours, options.reference, options.tolerance);
  std::printf("%s\n", result.text.c_str());
  if (!options.difference.empty() && result.difference.picture.width > 0)
    write_png(options.difference, result.difference.picture);
  return result.same ? kFine : kRunFailed;
}

}  // namespace

Command add_compare(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("compare", "Check whether two pictures look the same.");
  const auto options = std::make_shared<CompareArguments>();
  command->add_option("picture", options->ours, "PNG file")->type_name("A.png")->required();
  command->add_option("reference", options->reference, "PNG file that it should look like")
      ->type_name("B.png")
      ->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "largest difference allowed in a colour channel of a pixel, 0 to 255")
      ->type_name("N")
      ->check(whole_in_range(0, 255))
      ->capture_default_str();
  command
      ->add_option("--difference", options->difference,
                   "write a picture of the differences, amplified eight times")
      ->type_name("D.png");
  command->footer(
      "Exit code: 0 if they look the same, 1 if not, 2 if one is not a picture.\n\n"
      "Examples:\n"
      "  quicksand compare out/tour/04_push.png reference/04_push.png\n"
      "  quicksand compare now.png before.png --tolerance 0 --difference changes.png");
  return {command, [options] { return compare(*options); }};
}

}  // namespace quicksand
