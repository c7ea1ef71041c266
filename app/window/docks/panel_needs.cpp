#include "app/window/docks/panel_needs.h"

#include "app/window/docks/panels.h"
#include "app/workspaces/field/field_panel.h"

namespace halbench::app {

bool isMet(PanelNeed need, const devices::DeviceInfo& info, const devices::Catalogue& catalogue) {
    const bool isReplayed = info.transport == "replay";
    switch (need) {
    case PanelNeed::Nothing:
        break;
    case PanelNeed::Drive:
        return !isReplayed && canBeDriven(catalogue);
    case PanelNeed::Recording:
        return !isReplayed;
    case PanelNeed::ControlLoop:
        return isReplayed || canBeDriven(catalogue);
    case PanelNeed::Identification:
        return isReplayed || catalogue.hasProcedure("identify");
    case PanelNeed::OneAxisIdentification:
        return isReplayed || (catalogue.hasProcedure("identify") && catalogue.axes.size() < 2);
    case PanelNeed::Calibration:
        return isReplayed || catalogue.hasProcedure("calibrate");
    case PanelNeed::Picture:
        return hasPicture(catalogue);
    }
    return true;
}

QSet<QString> absentPanels(const devices::DeviceInfo& info, const devices::Catalogue& catalogue) {
    QSet<QString> absent;
    for (const PanelSpec& spec : panelSpecs()) {
        if (!isMet(spec.need, info, catalogue) || (spec.isMadeFor && !spec.isMadeFor(catalogue))) {
            absent.insert(spec.id);
        }
    }
    return absent;
}

QStringList mainPanels(Perspective perspective) {
    switch (perspective) {
    case Perspective::Identify:
        return {QStringLiteral("identify"), QStringLiteral("calibrate")};
    case Perspective::Tune:
        return {QStringLiteral("tune")};
    case Perspective::Record:
        return {QStringLiteral("recordings")};
    case Perspective::Field:
        return {QStringLiteral("field")};
    case Perspective::Monitor:
        break;
    }
    return {QStringLiteral("monitor")};
}

} // namespace halbench::app
