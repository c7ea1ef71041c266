#include "app/workspaces/device/link_panel.h"

#include "app/workbench/pace_steps.h"
#include "app/workbench/shown_recording.h"
#include "widgets/controls/elided_label.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace halbench::app {

namespace {

/// Shortest stretch of device time over which a rate is worth showing.
constexpr double RateWindow_s = 0.5;
constexpr int LeastLine = 10; ///< characters of the last message; the rest in its tooltip

} // namespace

LinkPanel::LinkPanel(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_link = new widgets::ElidedLabel(LeastLine, this);
    m_link->setAccessibleName(tr("Link statistics"));
    m_link->setToolTip(
        tr("Packets per second (device time), lost, damaged, response time median and maximum"));
    m_link->setFont(widgets::tabularFont(font()));
    m_stream = new widgets::ElidedLabel(LeastLine, this);
    m_stream->setAccessibleName(tr("Signals sent to the plots"));
    m_stream->setFont(m_link->font());
    widgets::setRole(*m_stream, widgets::Role::Muted);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(widgets::PanelMargin_px, 0, widgets::PanelMargin_px, 0);
    row->setSpacing(widgets::GroupSpacing_px);
    m_log = new QToolButton(this);
    m_log->setText(tr("Log"));
    m_log->setToolTip(tr("Unfold or fold the log (F9)"));
    m_log->setFocusPolicy(Qt::NoFocus); // F9 is its key
    m_log->setAutoRaise(true);
    connect(m_log, &QToolButton::clicked, this, &LinkPanel::logRequested);
    m_line = new widgets::ElidedLabel(LeastLine, this);
    m_line->setAccessibleDescription(tr("Last message of the log"));
    row->addWidget(m_log);
    row->addWidget(m_line, 1);
    row->addWidget(m_stream);
    row->addWidget(m_link);
    connect(&m_bench.session(), &DeviceSession::reportChanged, this, &LinkPanel::refresh);
    connect(&m_bench.session(), &DeviceSession::stateChanged, this, &LinkPanel::refresh);
    connect(&m_bench.liveSignals(), &LiveSignals::changed, this, &LinkPanel::refresh);
    connect(&m_bench.shownRecording(), &ShownRecording::changed, this, &LinkPanel::refresh);
    refresh();
}

void LinkPanel::showLine(MessageLevel level, const QString& text) {
    m_line->setWords(text);
    widgets::setRole(*m_line, level == MessageLevel::Error     ? widgets::Role::Bad
                              : level == MessageLevel::Warning ? widgets::Role::Warn
                                                               : widgets::Role::Muted);
}

QString LinkPanel::streamWords() const {
    const LiveSignals& live = m_bench.liveSignals();
    const ShownRecording& shown = m_bench.shownRecording();
    const bool isVirtual =
        m_bench.session().info().isSimulated && m_bench.session().pace().speed_ratio <= 0.0;
    if (shown.file() != nullptr) {
        return tr("recording of %1 s").arg(widgets::fixedText(shown.length_s(), 2));
    }
    if (live.streamed().empty()) {
        return tr("no signals");
    }
    if (isVirtual) {
        return tr("time advances only during a procedure");
    }
    const QString words =
        tr("%n signal(s), %1 Hz, samples lost: %2", nullptr, static_cast<int>(live.streamed().size()))
            .arg(widgets::fixedText(live.rate_Hz(), 0), widgets::countText(m_bench.history().lostRows()));
    const double pace_ratio = m_bench.pace().speed_ratio;
    return canBePaced(m_bench) && pace_ratio != 1.0
               ? QStringLiteral("%1, %2").arg(words, paceWords(pace_ratio))
               : words;
}

void LinkPanel::refresh() {
    m_stream->setWords(streamWords());
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected) {
        m_link->setWords(session.state() == SessionState::Connecting     ? tr("link: connecting")
                         : session.state() == SessionState::Reconnecting ? tr("link: lost, reconnecting")
                                                                         : tr("link: none"));
        m_packets = 0;
        m_time_s = 0.0;
        return;
    }
    const devices::LinkStatistics& link = session.report().statistics;
    const double time_s = session.report().deviceTime_s;
    if (time_s - m_time_s >= RateWindow_s) {
        m_rate_Hz = static_cast<double>(link.packetsReceived - m_packets) / (time_s - m_time_s);
        m_packets = link.packetsReceived;
        m_time_s = time_s;
    }
    if (session.info().isSimulated || session.info().transport == "replay") {
        m_link->setWords({}); // there is none
        return;
    }
    m_link->setWords(tr("link: %1 packets/s, %2 lost, %3 damaged, %4 ms (max. %5 ms)")
                         .arg(widgets::fixedText(m_rate_Hz, 0), widgets::countText(link.packetsLost),
                              widgets::countText(link.packetsDamaged),
                              widgets::fixedText(link.roundTripMedian_s * 1e3, 1),
                              widgets::fixedText(link.roundTripWorst_s * 1e3, 1)));
}

} // namespace halbench::app
