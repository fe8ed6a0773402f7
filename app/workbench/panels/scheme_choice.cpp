#include <algorithm>

#include <imgui.h>

#include "workbench/glossary.hpp"
#include "workbench/panels/panel.hpp"

namespace percuss::app {

void show_scheme_choice(Workbench& w) {
    const std::vector<SchemeChoice>& choices = w.run.schemes();
    const auto present =
        std::find_if(choices.begin(), choices.end(), [](const SchemeChoice& c) { return c.present; });
    const std::string shown = present == choices.end() ? "another" : present->name;
    ImGui::SetNextItemWidth(0.36F * ImGui::GetWindowWidth());
    const std::string help = present != choices.end() ? find_scheme(present->name)->explanation : "";
    if (begin_choice(w, "##scheme", shown, "scheme", help)) {
        const Scene& scene = w.run.snapshot()->setup->scene;
        for (const SchemeChoice& choice : choices) {
            const bool usable = choice.fault.empty();
            const NamedScheme& scheme = *find_scheme(choice.name);
            if (ImGui::Selectable(choice.name.c_str(), choice.present,
                                  usable ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled))
                w.run.set_all(scheme_overrides(scheme, scene));
            w.names.name("scheme." + choice.name);
            tooltip(usable ? scheme.explanation : choice.fault);
        }
        ImGui::EndCombo();
    }
    ImGui::SameLine(0, 1.2F * ImGui::GetFontSize());
    line_of_text("contact scheme", false,
                 "How contact is computed. Between projection and joint a run goes on; what else builds it "
                 "anew.\n" +
                     explain("contact scheme"));
}

}  // namespace percuss::app
