#pragma once

#include "devices/device.h"

#include <QComboBox>

#include <string>

namespace halbench::app {

/// Chooses one of the device's signals from a list, or by dropping one from the tree of signals.
class SignalBox : public QComboBox {
    Q_OBJECT
public:
    explicit SignalBox(QWidget* parent);

    /// Keeps the choice if the device has that signal; else the first of the roles that it has.
    void setCatalogue(const devices::Catalogue& catalogue, const std::vector<const char*>& roles);
    /// Empty: none.
    std::string signal() const;
    void choose(const QString& name);

Q_SIGNALS:
    void chosen(); ///< by the user

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
};

} // namespace halbench::app
