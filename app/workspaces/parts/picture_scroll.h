#pragma once

#include <QWidget>

class QScrollArea;

namespace halbench::widgets {
class FigureView;
class VerdictView;
} // namespace halbench::widgets

namespace halbench::app {

/// Figure with the remarks of a verdict below it, scrolled: the figure fills the place and the remarks begin
/// at the lower edge. Thread: GUI.
class PictureScroll : public QWidget {
    Q_OBJECT
public:
    explicit PictureScroll(widgets::VerdictView& verdict, QWidget* parent = nullptr);

    widgets::FigureView& picture() { return *m_picture; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    widgets::FigureView* m_picture;
    QScrollArea* m_scroll = nullptr;
};

} // namespace halbench::app
