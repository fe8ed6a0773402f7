#include "workbench/glossary.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace percuss::app {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

}  // namespace

const std::vector<Term>& glossary() {
    static const std::vector<Term> terms{
        {{"active nodes", "active"}, "Master nodes that have a contact force in this step."},
        {{"averaged triangle", "averaged triangles"},
         "Triangle whose volume change is averaged at the nodes, so that meshes of triangles do not lock "
         "where a "
         "material hardly changes its volume."},
        {{"axial"}, "Along the axis of an axisymmetric scene, its second coordinate z."},
        {{"axisymmetric"},
         "The scene is a half section that turns about its axis; forces are of the full ring."},
        {{"balance", "balance e"},
         "What the contact took away so far: energy put in, less kinetic and internal energy. It never falls "
         "in a "
         "sound run."},
        {{"body force"}, "A force on each unit of mass, as weight is."},
        {{"bulk viscosity"},
         "A pressure that resists fast compression. It smears a shock over some elements instead of letting "
         "it ring, "
         "and lowers the critical step a little."},
        {{"chatter", "open/close events"},
         "Contacts opening and closing in quick turn while waves run between the bodies. Each master node "
         "that gains "
         "or loses its force counts once."},
        {{"contact search"}, "Finding the master nodes that the step would carry into a slave side."},
        {{"contact solve"}, "Finding the contact forces that let no found node penetrate."},
        {{"Courant number", "Courant"},
         "Time step as a fraction of the critical one; at most 1, and below 1 where elements shrink."},
        {{"critical step", "critical"},
         "The longest time step for which the explicit scheme is stable: about the time that a wave takes "
         "through the "
         "smallest element."},
        {{"displacement"}, "How far a node has moved from where it stood at the start."},
        {{"element"}, "A cell of the mesh: the material between three or four nodes."},
        {{"external", "external energy"},
         "Initial kinetic energy and what loads, body forces and prescribed motion have put in since."},
        {{"friction"}, "Tangential contact force, up to Coulomb's coefficient times the normal one."},
        {{"hoop stress", "hoop"}, "Stress around the axis, which widening a ring calls up."},
        {{"hourglass", "hourglass energy", "hourglass stiffness"},
         "Deformation of a one-point quad that its single integration point does not see. A small stiffness "
         "holds it; "
         "its energy should stay a small part of the internal one."},
        {{"integration"},
         "New velocities from forces and new positions from velocities, and the sums of the ledger."},
        {{"internal", "internal energy"},
         "Work that the bodies have taken up: elastic, plastic, hourglass and viscous."},
        {{"Johnson-Cook"},
         "Yield stress that grows with plastic strain and its rate and falls with temperature."},
        {{"joint"},
         "Contact scheme: one problem for all pairs that share nodes, so that no pair undoes what another "
         "one "
         "corrected."},
        {{"kinetic", "kinetic energy"}, "Energy of motion, of all bodies together."},
        {{"lagged stresses", "lagged"},
         "A teaching mode: stresses see the positions before contact has corrected them."},
        {{"master", "master node", "master nodes"},
         "The side of a contact pair whose nodes are kept out of the other side."},
        {{"mean dilatation", "mean-dilatation", "mean-dilatation quads"},
         "Quadrilateral with four stress points and one volume change for all of them: it neither locks nor "
         "needs "
         "hourglass stiffness, and costs about three one-point quads."},
        {{"one-point quad", "one-point quads"},
         "Quadrilateral with one stress point: the fastest element; hourglass stiffness holds what that "
         "point does "
         "not see."},
        {{"penetration"},
         "How deep a master node lies within a slave side; what is left after the correction."},
        {{"plastic", "plastic energy"}, "Work spent in plastic flow, which does not come back."},
        {{"plastic strain"},
         "Equivalent plastic strain: the sum of all plastic flow so far, 0 where none was."},
        {{"prescribed velocity", "drive"},
         "A motion that the scene imposes; the drive is the force that it takes."},
        {{"pressure"}, "Mean of the three normal stresses with the opposite sign: positive in compression."},
        {{"probe", "probes"}, "A place of a body at which a quantity is read at each step."},
        {{"projection"},
         "Contact scheme of the paper: master nodes are projected onto the slave side, pair by pair in the "
         "order of "
         "the scene."},
        {{"radial"}, "Away from the axis of an axisymmetric scene, its first coordinate r."},
        {{"reference"}, "A run that was kept to compare the next ones with."},
        {{"shear stress", "shear"}, "Stress along the planes of the two coordinates, not across them."},
        {{"slave", "slave side", "slave sides"},
         "The side of a contact pair whose element sides the master nodes must not enter."},
        {{"sticking"}, "Master nodes that touch and do not slide."},
        {{"stress"}, "Force on a unit of area; tension is positive."},
        {{"temperature"}, "Of the material where plastic work heats it; elsewhere what it was at the start."},
        {{"time step"}, "How far the scene advances at once."},
        {{"traction"}, "A force on each unit of a side's area, normal or tangential."},
        {{"viscous", "viscous energy"}, "Work taken up by bulk viscosity."},
        {{"von Mises stress", "von Mises"},
         "One number for a state of stress, which tells how near it is to yielding; never negative."},
        {{"yield margin"}, "What is left before the material yields: 1 without stress, 0 where it flows."},
    };
    return terms;
}

const std::string& meaning_of(std::string_view term) {
    for (const Term& known : glossary())
        if (std::find(known.words.begin(), known.words.end(), term) != known.words.end())
            return known.meaning;
    throw std::logic_error("the glossary lacks '" + std::string(term) + "'");
}

std::string explain(std::string_view text) {
    const std::string words = lower(text);
    struct Found {
        std::size_t begin, end;
        const Term* term;
    };
    std::vector<Found> found;
    for (const Term& term : glossary())
        for (const std::string& word : term.words)
            for (std::size_t at = words.find(lower(word)); at != std::string::npos;
                 at = words.find(lower(word), at + 1)) {
                const std::size_t end = at + word.size();
                const bool whole =
                    (at == 0 || !is_letter(words[at - 1])) && (end == words.size() || !is_letter(words[end]));
                if (whole) found.push_back({at, end, &term});
            }
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
    });
    std::string result;
    std::vector<const Term*> told;
    std::size_t covered = 0;
    for (const Found& place : found) {
        if (place.end <= covered) continue;
        covered = place.end;
        if (std::find(told.begin(), told.end(), place.term) != told.end()) continue;
        told.push_back(place.term);
        result += (result.empty() ? "" : "\n") + place.term->words.front() + ": " + place.term->meaning;
    }
    return result;
}

}  // namespace percuss::app
