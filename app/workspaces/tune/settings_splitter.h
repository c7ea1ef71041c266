#pragma once

#include <QSplitter>

namespace halbench::app {

/// Splitter of settings and pictures: the settings keep their smallest width and the pictures get the rest,
/// until the user moves the handle. Thread: GUI.
class SettingsSplitter : public QSplitter {
    Q_OBJECT
public:
    SettingsSplitter(QWidget* settings, QWidget* pictures, QWidget* parent = nullptr);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void shareWidth();

    bool m_isMoved = false; ///< by the user
};

} // namespace halbench::app
