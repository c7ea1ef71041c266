#include "app/workspaces/device/return_notice.h"

#include "app/workspaces/parts/panel_parts.h"
#include "widgets/controls/message_bar.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/theme_style.h"

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

namespace halbench::app {

namespace {

/// The Parameters panel has them all.
constexpr std::size_t MostListed = 6;
constexpr int Digits = 7; ///< of a 32 bit float

QString number(double value) {
    return widgets::numberText(value, Digits);
}

} // namespace

ReturnNotice::ReturnNotice(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_message = new widgets::MessageBar(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_message);
    buildDifferences();
    column->addWidget(m_differences);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &ReturnNotice::onState);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, &ReturnNotice::showSearch);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, [this] {
        refreshWrite();
        endWhenArmed();
    });
    connect(&m_bench.session(), &DeviceSession::procedureChanged, this, &ReturnNotice::refreshWrite);
    connect(&m_bench, &Workbench::valuesCompared, this, &ReturnNotice::showReturn);
    connect(m_accept, &QPushButton::clicked, this, [this] {
        m_decision = tr("Device values kept.");
        m_bench.acceptDifferences();
    });
    connect(m_write, &QPushButton::clicked, this, &ReturnNotice::writeBack);
}

void ReturnNotice::buildDifferences() {
    m_differences = new QWidget(this);
    m_list = new QLabel(m_differences);
    m_list->setAccessibleName(tr("Changed values"));
    m_list->setToolTip(tr("Left: before the connection was lost; right: now"));
    m_list->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_list->setFocusPolicy(Qt::ClickFocus);
    m_list->setFont(widgets::tabularFont(m_list->font()));
    m_write = makeButton(
        {tr("Write old values"), tr("Write the values from before the loss and read them back"), {}},
        m_differences);
    m_accept = makeButton({tr("Keep device values"), tr("Keep the values that are on the device now"), {}},
                          m_differences);
    auto* row = new QHBoxLayout(m_differences);
    row->setContentsMargins(widgets::PanelMargin_px, widgets::GridStep_px, widgets::PanelMargin_px,
                            widgets::GridStep_px);
    row->setSpacing(widgets::GroupSpacing_px);
    row->addWidget(m_list);
    row->addWidget(m_write, 0, Qt::AlignTop);
    row->addWidget(m_accept, 0, Qt::AlignTop);
    row->addStretch(1);
    m_differences->hide();
}

void ReturnNotice::onState() {
    const SessionState state = m_bench.session().state();
    if (state == SessionState::Reconnecting) {
        m_hasDiffered = false;
        m_decision.clear();
        showSearch();
    } else if (state != SessionState::Connected || m_bench.session().returns() == 0) {
        m_message->clear();
        m_differences->hide();
    }
    m_accept->setEnabled(state == SessionState::Connected);
    refreshWrite();
}

/// Values of a loop that runs are not changed all at once.
void ReturnNotice::refreshWrite() {
    const DeviceSession& session = m_bench.session();
    m_write->setEnabled(session.state() == SessionState::Connected && session.procedure().isEmpty() &&
                        !session.report().board.isArmed);
}

/// What is shown already is left alone: it is said anew ten times a second.
void ReturnNotice::say(const widgets::Message& message) {
    if (m_message->message().text != message.text || m_message->message().remedy != message.remedy) {
        m_message->showMessage(message);
    }
}

void ReturnNotice::showSearch() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Reconnecting || !session.report().lost) {
        return;
    }
    const QString last = widgets::inWords(session.report().notBack);
    const QString search =
        last.isEmpty() ? tr("Reconnecting.") : tr("Reconnecting; last attempt: %1.").arg(last);
    say({widgets::Severity::Warning,
         tr("Connection lost: %1.").arg(widgets::inWords(session.report().lost->message)),
         search + QLatin1Char(' ') + tr("The device's watchdog stops the motion.") + QLatin1Char(' ') +
             (m_bench.recording().isRecording() ? tr("The recording continues with a gap.") + QLatin1Char(' ')
                                                : QString()) +
             tr("Disconnect ends the search."),
         {}});
}

void ReturnNotice::showReturn() {
    const QString outage = widgets::fixedText(m_bench.session().outage_s(), 1);
    if (m_bench.differences().empty()) {
        say({widgets::Severity::Success,
             tr("Reconnected after %1 s, disarmed.").arg(outage),
             !m_hasDiffered         ? tr("Its values are unchanged.")
             : m_decision.isEmpty() ? tr("The changed values were edited in the meantime.")
                                    : m_decision,
             {}});
    } else {
        m_hasDiffered = true;
        m_decision.clear();
        say({widgets::Severity::Warning,
             tr("Reconnected after %1 s, disarmed. Changed values: %2.")
                 .arg(outage)
                 .arg(m_bench.differences().size()),
             tr("The device may have restarted. Nothing was written."),
             {}});
    }
    showDifferences();
    endWhenArmed();
}

/// It said what was so when the device came back; whoever arms has gone on. What differs stays to be decided.
void ReturnNotice::endWhenArmed() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected || !session.report().board.isArmed) {
        return;
    }
    if (m_bench.differences().empty()) {
        m_message->clear();
    } else {
        say({widgets::Severity::Warning,
             tr("Values changed during the connection loss: %1.").arg(m_bench.differences().size()),
             tr("The device may have restarted. Nothing was written."),
             {}});
    }
}

void ReturnNotice::showDifferences() {
    const std::vector<ValueDifference>& all = m_bench.differences();
    if (all.empty()) {
        leaveFocus();
    }
    m_differences->setVisible(!all.empty());
    QStringList lines;
    for (std::size_t i = 0; i < std::min(all.size(), MostListed); ++i) {
        const ParameterSpec* spec = m_bench.session().catalogue().findParameter(all[i].name);
        lines << QStringLiteral("%1: %2 \u2192 %3 %4")
                     .arg(QString::fromStdString(all[i].name), number(all[i].before), number(all[i].now),
                          spec == nullptr ? QString() : QString::fromStdString(spec->unit))
                     .trimmed();
    }
    if (all.size() > MostListed) {
        lines << tr("and %1 more").arg(all.size() - MostListed);
    }
    m_list->setText(lines.join(QLatin1Char('\n')));
}

/// Here no key does anything; the next control in the chain would be Keep, then Disconnect.
void ReturnNotice::leaveFocus() {
    if (m_differences->isAncestorOf(window()->focusWidget())) {
        setFocus(Qt::OtherFocusReason);
    }
}

void ReturnNotice::writeBack() {
    leaveFocus();
    m_write->setEnabled(false);
    m_decision = tr("Old values written.");
    m_bench.writeDifferencesBack([self = QPointer(this)](const Result<void>& written) {
        if (!self) {
            return;
        }
        self->refreshWrite();
        if (!written) {
            self->m_decision.clear();
            self->say({widgets::Severity::Error,
                       widgets::inWords(written.error().message),
                       widgets::inWords(written.error().hint),
                       {}});
        }
    });
}

} // namespace halbench::app
