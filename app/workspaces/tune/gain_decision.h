#pragma once

#include "app/procedures/apply/apply_procedure.h"
#include "app/workbench/workbench.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::widgets {
struct Message;
}

namespace halbench::app {

class DesignComparison;
class TuneMessages;
class TuneSession;

/// Application of gains to the device and the decision on them: idle, applying, undecided, kept. Undecided
/// gains are kept or the replaced ones restored; gains that only a board's working memory has are saved as a
/// design when they are kept and when the device is left. Thread: GUI.
class GainDecision : public QObject {
    Q_OBJECT
public:
    /// All of them outlive it.
    GainDecision(Workbench& bench, const TuneSession& session, DesignComparison& designs,
                 TuneMessages& messages, QObject* parent = nullptr);

    /// Writes the proposed gains, which exist, and verifies them by a move; `isGradual`: in small steps.
    void apply(bool isGradual);
    void keep();
    void restore();
    /// The device keeps its gains without power from now on.
    void onSavedInDevice();
    /// Saves what was applied to the former device as a design, where another one is connected, looked for,
    /// or held while a recording is open. Returns whether that is so.
    bool leaveDevice();

    bool isApplying() const { return m_isApplying; }
    bool isUndecided() const { return !m_before.empty(); }
    /// Not yet: the picture has to be seen first.
    bool isLooking() const { return m_look.isActive(); }
    /// Values of the device, with those that an undecided apply replaced.
    std::map<std::string, double> valuesBefore() const;

Q_SIGNALS:
    void started(const halbench::app::LoopLaw& law); ///< nothing is written yet
    void verified(const halbench::app::ApplyResult& result);
    void changed();
    void settled(); ///< after changed(): the next step is due; not after an error
    void looked();  ///< after changed(): a decision can be meant now
    void kept();    ///< after settled()
    void restored();
    void left(const QString& text, const QString& remedy, const QString& design);

private:
    /// Gains of this panel that a device has in its working memory.
    struct AppliedGains {
        std::string document; ///< as Save gains writes it
        LoopLaw law;
        QString device;
        bool isSimulated = false;
    };

    void start(const LoopLaw& law, std::vector<ParameterValue> values, bool isGradual);
    void finish(const Result<ApplyResult>& result);
    void showFailure(const Error& error);
    void await(const ApplyResult& result);
    void tell(MessageLevel level, const widgets::Message& message);
    QString savedName(const AppliedGains& gains, const QString& stem);
    void leaveGains();

    Workbench& m_bench;
    const TuneSession& m_session;
    DesignComparison& m_designs;
    TuneMessages& m_messages;
    bool m_isApplying = false;
    std::optional<AppliedGains> m_applying;
    std::optional<AppliedGains> m_undecided;
    std::optional<AppliedGains> m_kept;
    std::vector<ParameterValue> m_before; ///< replaced values; empty when that is decided
    std::uint64_t m_deviceNumber = 0;     ///< of these gains; 0: none
    QTimer m_look;
};

} // namespace halbench::app
