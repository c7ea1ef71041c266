#pragma once

#include <QDialog>
#include <QString>

namespace halbench::app {

/// Version, licence and libraries, as text for a report of a fault.
QString aboutText();

/// Purpose, versions and licence of the program, to be copied. Carries a small STOP.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget* parent = nullptr);

Q_SIGNALS:
    void stopRequested();
};

} // namespace halbench::app
