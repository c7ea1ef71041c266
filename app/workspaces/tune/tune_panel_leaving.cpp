// Gains that only a board's working memory has: the project keeps them, and who leaves the board is told.
#include "app/workspaces/tune/tune_panel.h"
#include "widgets/controls/message_bar.h"

#include <algorithm>
#include <utility>

namespace halbench::app {

void TunePanel::keep() {
    m_before.clear();
    QString remedy = tr("To keep them: Save to device, in the Parameters panel.");
    if (m_undecided) {
        m_onDevice = std::exchange(m_undecided, std::nullopt);
        const QString design = keptDesignOf(*m_onDevice, tr("kept on %1"));
        remedy = m_onDevice->isSimulated
                     ? tr("They are saved as design '%1' and can be applied again.").arg(design)
                     : remedy + QLatin1Char(' ') + tr("They are saved as design '%1'.").arg(design);
    }
    const bool isSimulated = m_bench.session().info().isSimulated; // new whenever it is connected
    const QString until =
        isSimulated ? tr("New gains active until disconnect.") : tr("New gains active until power-off.");
    m_bench.session().message(MessageLevel::Info, tr("Tune"), until);
    tellOfDevice({widgets::Severity::Information, until, remedy,
                  isSimulated ? tr("Drive the motor") : tr("Open Parameters")});
    refreshButtons();
    focusNext();
    readConditions(); // the gains on the device are those to compare with from now on
}

/// In the project under a name of its own, unless it has these gains already; returns that name.
QString TunePanel::keptDesignOf(const AppliedGains& gains, const QString& stem) {
    const auto& all = m_designs.all();
    const auto same = std::find_if(all.begin(), all.end(), [&](const KeptDesign& design) {
        return design.document == gains.document ||
               (design.gains && design.gains->loopLaw() == LoopLaw(gains.law));
    });
    if (same != all.end()) {
        return QString::fromStdString(same->name);
    }
    const std::string name = m_designs.adopt(stem.arg(gains.device).toStdString(), gains.document);
    compareDesigns();
    return QString::fromStdString(name);
}

/// The device is left: nothing asks, nothing is lost.
void TunePanel::leaveGains() {
    const auto kept = std::exchange(m_onDevice, std::nullopt);
    const auto undecided = std::exchange(m_undecided, std::nullopt);
    if (!kept && !undecided) {
        return;
    }
    const AppliedGains& gains = undecided ? *undecided : *kept;
    if (kept && undecided) {
        keptDesignOf(*kept, tr("kept on %1")); // whatever became of it meanwhile
    }
    const QString design = keptDesignOf(gains, undecided ? tr("applied on %1") : tr("kept on %1"));
    const QString what = undecided ? tr("Gains applied on %1 were neither kept nor restored.")
                                   : tr("%1 was disconnected with the kept gains.");
    const QString until = gains.isSimulated ? tr("A simulated device is reset on disconnect.")
                                            : tr("They stay active until power-off.");
    const QString text = what.arg(gains.device) + QLatin1Char(' ') + until;
    const QString remedy =
        tr("They are saved as design '%1'. To use them: Use this design, then Apply and verify.").arg(design);
    m_bench.session().message(MessageLevel::Info, tr("Tune"), text + QLatin1Char(' ') + remedy);
    Q_EMIT gainsLeft(text, remedy, design);
}

void TunePanel::takeUpDesign(const std::string& name) {
    const auto& all = m_designs.all();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const KeptDesign& design) { return design.name == name; });
    if (found != all.end()) {
        takeUp(static_cast<int>(found - all.begin()));
    }
}

void TunePanel::onSavedInDevice() {
    m_onDevice.reset();
    m_undecided.reset();
}

} // namespace halbench::app
