#include "widgets/language/window_terms.h"

#include <QCoreApplication>

#include <utility>

namespace halbench::widgets {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::WindowTerms)
};

} // namespace

std::optional<QString> windowTerms(const QString& hint) {
    const std::pair<const char*, QString> terms[] = {
        {"give the inertia (--given J=...) or the torque constant (--given phi=...), or repeat with a known "
         "inertia fixed to the rotor (--bare, --added-inertia)",
         Words::tr("choose Identify again and enter the given inertia J or the given torque constant φ")},
        {"identify the bare motor again without --given",
         Words::tr("identify the bare motor again with empty constants")},
        {"steady speeds alone do not show the inertia: identify with run-ups and coast-downs, or give the "
         "constant that is known (--given J=...)",
         Words::tr("steady speeds alone do not determine the inertia: identify again with run-ups and "
                   "coast-downs, or enter the given inertia J")},
        {"add --bandwidth-hz HZ", Words::tr("enter the required bandwidth")},
        {"add --phase-margin-deg DEG", Words::tr("enter the required phase margin")}};
    for (const auto& [below, here] : terms) {
        if (hint == QString::fromUtf8(below)) {
            return here;
        }
    }
    return std::nullopt;
}

} // namespace halbench::widgets
