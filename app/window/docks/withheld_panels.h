#pragma once

#include <QByteArray>
#include <QHash>
#include <QSet>
#include <QString>

namespace ads {
class CDockWidget;
}

namespace halbench::app {

/// Panels that the open device has no use for: closed while it is open, and open again with a device that
/// has. Arrangements are kept with these panels open, so that one device leaves no mark on another's. Thread:
/// GUI.
class WithheldPanels {
public:
    explicit WithheldPanels(const QHash<QString, ads::CDockWidget*>& docks) : m_docks(docks) {}

    bool isAbsent(const QString& id) const { return m_absent.contains(id); }
    /// Opens what was closed for the device before and closes what this one lacks. False: the same panels.
    bool setAbsent(QSet<QString> absent);
    /// After an arrangement was shown.
    void close();
    /// Before an arrangement is shown.
    void forget() { m_closed.clear(); }
    /// The state of the docking library with the withheld panels open.
    QByteArray opened(QByteArray state) const;

private:
    void open(const QString& id, bool isInFront);

    const QHash<QString, ads::CDockWidget*>& m_docks;
    QSet<QString> m_absent;
    QHash<QString, bool> m_closed; ///< by this; whether it was the tab in front
};

} // namespace halbench::app
