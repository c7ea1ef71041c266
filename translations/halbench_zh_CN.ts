<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Panels</name>
    <message>
        <source>Monitor</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Field &amp;&amp; Pose</source>
        <translation>磁场与位姿</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>磁场</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>Derived signals</source>
        <translation>派生信号</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>记录列表</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>Relay experiment</source>
        <translation>继电实验</translation>
    </message>
    <message>
        <source>Monitor 2</source>
        <translation>监视 2</translation>
    </message>
    <message>
        <source>Monitor 3</source>
        <translation>监视 3</translation>
    </message>
    <message>
        <source>Estimators</source>
        <translation>估计器</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>角度误差</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source> And {}. {}</source>
        <translation> 另外，{}。{}</translation>
    </message>
    <message>
        <source>When it stood in another cell, disarm it, bring it to the middle of its travel, set hb.home to 1 and start again.</source>
        <translation>若其停在另一单元，请解除使能，将其移到行程中间，把 hb.home 设为 1，然后重新开始。</translation>
    </message>
    <message>
        <source>the device was not homed: where it stood was taken for its first cell, from which positions and the ends of travel count</source>
        <translation>设备尚未回零：其停留处被当作第一个单元，位置与行程端点均由此计数</translation>
    </message>
    <message>
        <source>Check its sensors, home the axes, then start again. Nothing was armed.</source>
        <translation>请检查其传感器，使各轴回零，然后重新开始。未使能任何部件。</translation>
    </message>
    <message>
        <source>&apos;line&apos; must be &apos;solid&apos;, &apos;dash&apos;, &apos;dot&apos; or &apos;dash-dot&apos;</source>
        <translation>“line”必须是“solid”、“dash”、“dot”或“dash-dot”</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a curve has colour, line, name</source>
        <translation>未知键“{}”；曲线有 colour、line、name</translation>
    </message>
    <message>
        <source>&apos;curves&apos; must be a table of signals, [monitor.curves]</source>
        <translation>“curves”必须是信号表，[monitor.curves]</translation>
    </message>
    <message>
        <source>Coulomb friction</source>
        <translation>库仑摩擦</translation>
    </message>
    <message>
        <source>this device has several axes, but its identification is of one</source>
        <translation>此设备有多个轴，但其辨识只针对一个轴</translation>
    </message>
    <message>
        <source>update the program</source>
        <translation>请更新程序</translation>
    </message>
    <message>
        <source>there is no loop to shape yet</source>
        <translation>尚无可调整的回路</translation>
    </message>
    <message>
        <source>choose a method first</source>
        <translation>请先选择一种方法</translation>
    </message>
    <message>
        <source>the loop of axis {} is still computed</source>
        <translation>轴 {} 的回路仍在计算</translation>
    </message>
    <message>
        <source>wait until its verdict is there</source>
        <translation>请等待其评判结果</translation>
    </message>
    <message>
        <source>the gains of the device are not known</source>
        <translation>设备的增益未知</translation>
    </message>
    <message>
        <source>connect it and wait until its values are read</source>
        <translation>请连接设备并等待读取其数值</translation>
    </message>
    <message>
        <source>Stable with little reserve: check the warnings</source>
        <translation>稳定但余量小：请检查警告</translation>
    </message>
    <message>
        <source>Command of law and excitation about the vertical</source>
        <translation>控制律与激励绕垂直轴的指令</translation>
    </message>
    <message>
        <source>Command of law and excitation along y</source>
        <translation>控制律与激励沿 y 的指令</translation>
    </message>
    <message>
        <source>Command of law and excitation along x</source>
        <translation>控制律与激励沿 x 的指令</translation>
    </message>
    <message>
        <source>Deviation of a reading: noise</source>
        <translation>读数的偏差：噪声</translation>
    </message>
    <message>
        <source>Deviation that errors of the calibration leave in a reading</source>
        <translation>标定剩余误差在读数中留下的偏差</translation>
    </message>
    <message>
        <source>From line to line, along y</source>
        <translation>行与行沿 y 的间距</translation>
    </message>
    <message>
        <source>Largest acceleration on the path</source>
        <translation>轨迹上的最大加速度</translation>
    </message>
    <message>
        <source>Largest jerk on the path</source>
        <translation>轨迹上的最大加加速度</translation>
    </message>
    <message>
        <source>Largest speed on the path</source>
        <translation>轨迹上的最大速度</translation>
    </message>
    <message>
        <source>Length of a line, along x</source>
        <translation>一行沿 x 的长度</translation>
    </message>
    <message>
        <source>Of the circle</source>
        <translation>圆的</translation>
    </message>
    <message>
        <source>Of the raster</source>
        <translation>光栅的</translation>
    </message>
    <message>
        <source>Speed along the path: with jumps of the acceleration or with a largest jerk</source>
        <translation>沿轨迹的速度：加速度有跳变，或加加速度受限</translation>
    </message>
    <message>
        <source>Largest acceleration of trapezoid and S-curve, per second squared</source>
        <translation>梯形和 S 曲线的最大加速度（每平方秒）</translation>
    </message>
    <message>
        <source>Largest jerk of the S-curve, per second cubed</source>
        <translation>S 曲线的最大加加速度（每三次方秒）</translation>
    </message>
    <message>
        <source>Slope of the ramp, speed of trapezoid and S-curve, per second</source>
        <translation>斜坡的斜率、梯形和 S 曲线的速度（每秒）</translation>
    </message>
    <message>
        <source>Where the reference goes in mode position: to the law, or added to its command</source>
        <translation>位置模式下参考的去向：送入控制律，或叠加到其指令</translation>
    </message>
    <message>
        <source>Amplitudes of the harmonics (4,2), (6,2), (6,6), (10,10) at 50 mm</source>
        <translation>50 mm 处谐波 (4,2)、(6,2)、(6,6)、(10,10) 的幅值</translation>
    </message>
    <message>
        <source>force or torque</source>
        <translation>力或转矩</translation>
    </message>
    <message>
        <source>raster</source>
        <translation>光栅</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>s-curve</source>
        <translation>S 曲线</translation>
    </message>
    <message>
        <source>path</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>use calibrate or record</source>
        <translation>请使用 calibrate 或 record</translation>
    </message>
    <message>
        <source>this device senses and does not drive: there is nothing to identify</source>
        <translation>该设备只测量、不驱动：没有可辨识的量</translation>
    </message>
    <message>
        <source>comes to rest</source>
        <translation>静止下来</translation>
    </message>
    <message>
        <source>Its catalogue needs position, current.coil1 to 6 and hall.x1 to y3.</source>
        <translation>其目录需要 position、current.coil1 至 6 以及 hall.x1 至 y3。</translation>
    </message>
    <message>
        <source>the device lacks a signal of the platen</source>
        <translation>设备缺少动子的某个信号</translation>
    </message>
    <message>
        <source>no rows came from the device</source>
        <translation>设备没有发来任何行</translation>
    </message>
    <message>
        <source>sweeps over a pitch</source>
        <translation>扫描一个节距</translation>
    </message>
    <message>
        <source>goes to the start of a line</source>
        <translation>移向一条线的起点</translation>
    </message>
    <message>
        <source>goes to the next line</source>
        <translation>移向下一条线</translation>
    </message>
    <message>
        <source>sweeps at constant speed</source>
        <translation>以恒速扫描</translation>
    </message>
    <message>
        <source>goes to a place between</source>
        <translation>移向中间位置</translation>
    </message>
    <message>
        <source>goes back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>goes to a line</source>
        <translation>移向一条线</translation>
    </message>
    <message>
        <source>give the one that is known better; the other is then measured</source>
        <translation>请给出更准确已知的那个；另一个将被测出</translation>
    </message>
    <message>
        <source>one given constant is enough: m or Iz</source>
        <translation>给定一个常数即可：m 或 Iz</translation>
    </message>
    <message>
        <source>leave them out; this device takes an axis and a given m or Iz</source>
        <translation>请去掉它们；此设备接受一个轴以及给定的 m 或 Iz</translation>
    </message>
    <message>
        <source>{} = {} must be positive</source>
        <translation>{} = {} 必须为正</translation>
    </message>
    <message>
        <source>known are m (kg) and Iz (kg*m^2)</source>
        <translation>已知的有 m (kg) 和 Iz (kg*m^2)</translation>
    </message>
    <message>
        <source>the platen has no constant &apos;{}&apos;</source>
        <translation>动子没有常数 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>{} of {} windows of the motion miss rows</source>
        <translation>{} 个（共 {} 个）运动窗缺行</translation>
    </message>
    <message>
        <source>Set coil.force_constant to {}; the published model leaves out the corners of the windings.</source>
        <translation>请将 coil.force_constant 设为 {}；已发表的模型忽略了绕组的拐角。</translation>
    </message>
    <message>
        <source>the board counts with {} N/A, the coils give {} N/A</source>
        <translation>控制板按 {} N/A 计算，线圈实际为 {} N/A</translation>
    </message>
    <message>
        <source>Set platen.inertia and feedforward.phi.inertia to it, and tune phi again: its loop gain is off by the same factor.</source>
        <translation>请将 platen.inertia 和 feedforward.phi.inertia 设为该值，并重新整定 phi:其环路增益相差同样的倍数。</translation>
    </message>
    <message>
        <source>the board&apos;s inertia of {} kg m^2 is contradicted: with {} kg the motion shows {} kg m^2 ({} to {})</source>
        <translation>控制板的转动惯量 {} kg m^2 与实测不符：质量为 {} kg 时运动显示 {} kg m^2（{} 到 {}）</translation>
    </message>
    <message>
        <source>Weigh the platen and give its mass: --given m=0.64, in an experiment given = { m = 0.64 }.</source>
        <translation>请称量动子并给出其质量：--given m=0.64，在实验中 given = { m = 0.64 }。</translation>
    </message>
    <message>
        <source>only ratios follow from the motion: mass, inertia, damping and force constants have no absolute value</source>
        <translation>运动只能给出比值：质量、惯量、阻尼和力常数没有绝对值</translation>
    </message>
    <message>
        <source>lag of the currents behind the board&apos;s outputs</source>
        <translation>电流相对控制板输出的滞后</translation>
    </message>
    <message>
        <source>centre of mass along y&apos;</source>
        <translation>质心 y&apos; 坐标</translation>
    </message>
    <message>
        <source>centre of mass along x&apos;</source>
        <translation>质心 x&apos; 坐标</translation>
    </message>
    <message>
        <source>friction of {}</source>
        <translation>{} 的摩擦</translation>
    </message>
    <message>
        <source>stiffness of the cable, {}</source>
        <translation>电缆刚度，{}</translation>
    </message>
    <message>
        <source>damping of {}</source>
        <translation>{} 的阻尼</translation>
    </message>
    <message>
        <source>{}, over mass</source>
        <translation>{}，与质量之比</translation>
    </message>
    <message>
        <source>force constant of coils 5 and 6</source>
        <translation>线圈 5 和 6 的力常数</translation>
    </message>
    <message>
        <source>force constant of coils 3 and 4</source>
        <translation>线圈 3 和 4 的力常数</translation>
    </message>
    <message>
        <source>force constant of coils 1 and 2</source>
        <translation>线圈 1 和 2 的力常数</translation>
    </message>
    <message>
        <source>inertia about the vertical</source>
        <translation>绕竖直轴的转动惯量</translation>
    </message>
    <message>
        <source>moving mass</source>
        <translation>运动质量</translation>
    </message>
    <message>
        <source>inertia over mass</source>
        <translation>转动惯量与质量之比</translation>
    </message>
    <message>
        <source>Nothing to do: an air film has none.</source>
        <translation>无需处理：气膜没有摩擦。</translation>
    </message>
    <message>
        <source>axis {}: friction is below the resolution, at most {} {}</source>
        <translation>轴 {}:摩擦低于分辨率，最多 {} {}</translation>
    </message>
    <message>
        <source>Design with the upper bound, or identify again with more room.</source>
        <translation>请用上限进行设计，或在更大空间内重新辨识。</translation>
    </message>
    <message>
        <source>axis {}: damping is below the resolution, at most {} 1/s</source>
        <translation>轴 {}:阻尼低于分辨率，最多 {} 1/s</translation>
    </message>
    <message>
        <source>The motion does not excite the axis enough: check that nothing holds the platen.</source>
        <translation>运动对该轴激励不足：请检查动子是否被卡住。</translation>
    </message>
    <message>
        <source>axis {}: the acceleration per effort is {} +- {} {}</source>
        <translation>轴 {}:单位作用量的加速度为 {} +- {} {}</translation>
    </message>
    <message>
        <source>stiffness over inertia of {}</source>
        <translation>{} 的刚度与惯量之比</translation>
    </message>
    <message>
        <source>Check that the signals are those of a platen.</source>
        <translation>请检查信号是否为动子的信号。</translation>
    </message>
    <message>
        <source>the equations of motion have no solution</source>
        <translation>运动方程无解</translation>
    </message>
    <message>
        <source>{} whole windows of motion are too few, {} had missing rows</source>
        <translation>{} 个完整的运动窗太少，其中 {} 个缺行</translation>
    </message>
    <message>
        <source>the motion does not tell the constants apart</source>
        <translation>运动无法区分各常数</translation>
    </message>
    <message>
        <source>Give it more room, or check that the currents flow.</source>
        <translation>请给予更大空间，或检查电流是否流过。</translation>
    </message>
    <message>
        <source>the motion does not excite every axis</source>
        <translation>运动没有激励所有轴</translation>
    </message>
    <message>
        <source>choose hall, stray or all; identify gives a bound of the friction</source>
        <translation>请选择 hall、stray 或 all；identify 会给出摩擦的上限</translation>
    </message>
    <message>
        <source>a platen on air has no static friction to calibrate</source>
        <translation>气浮动子没有可标定的静摩擦</translation>
    </message>
    <message>
        <source>Check the chips: one may be damaged or loose, or iron is near.</source>
        <translation>请检查芯片：可能有一个损坏或松动，或附近有铁。</translation>
    </message>
    <message>
        <source>Move it nearer to the middle, or widen window.x and window.y. Nothing was armed.</source>
        <translation>请将其移近中央，或放宽 window.x 和 window.y。未进行任何使能。</translation>
    </message>
    <message>
        <source>Check its amplifier and the link.</source>
        <translation>请检查其放大器和连接。</translation>
    </message>
    <message>
        <source>coil {} carried no pulses of current</source>
        <translation>线圈 {} 没有电流脉冲</translation>
    </message>
    <message>
        <source>Check the chips and the motion.</source>
        <translation>请检查芯片和运动。</translation>
    </message>
    <message>
        <source>the calibration of the chips is not determined</source>
        <translation>芯片标定无法确定</translation>
    </message>
    <message>
        <source>Check the chips: one may be dead, stuck or clipped.</source>
        <translation>请检查芯片：可能有一个失效、卡死或饱和。</translation>
    </message>
    <message>
        <source>the calibration of the chips does not converge</source>
        <translation>芯片标定不收敛</translation>
    </message>
    <message>
        <source>Record at least 200.</source>
        <translation>请至少记录 200 个。</translation>
    </message>
    <message>
        <source>{} samples are too few</source>
        <translation>{} 个采样太少</translation>
    </message>
    <message>
        <source>Start nearer to the middle, or widen window.x and window.y.</source>
        <translation>请从更靠近中央处开始，或放宽 window.x 和 window.y。</translation>
    </message>
    <message>
        <source>the motion covers {} mm, less than the pitch of {} mm</source>
        <translation>运动范围为 {} mm，小于节距 {} mm</translation>
    </message>
    <message>
        <source>Halbach torque motor</source>
        <translation>Halbach 转矩电机</translation>
    </message>
    <message>
        <source>use --device sim:htm</source>
        <translation>请使用 --device sim:htm</translation>
    </message>
    <message>
        <source>the parts of a motor are known of a simulated one only</source>
        <translation>只有仿真电机的部件是已知的</translation>
    </message>
    <message>
        <source>{}: gains of several axes, not of a single loop</source>
        <translation>{}：多轴的增益，而非单回路的增益</translation>
    </message>
    <message>
        <source>{} % of the axes within the model&apos;s uncertainty are unstable with this loop</source>
        <translation>模型不确定度范围内有 {} % 的轴在此回路下不稳定</translation>
    </message>
    <message>
        <source>the model has no covariance: robustness assumes an exactly known axis</source>
        <translation>模型没有协方差：稳健性按精确已知的轴计算</translation>
    </message>
    <message>
        <source>only the integral action removes the standstill error, slowly; a larger K_P narrows the band</source>
        <translation>只有积分作用能缓慢消除静态误差；更大的 K_P 可缩小该范围</translation>
    </message>
    <message>
        <source>reduce the set-point weight, or use a slower loop</source>
        <translation>请减小设定值权重，或采用较慢的回路</translation>
    </message>
    <message>
        <source>with friction and the effort limit of {} {} a step of {} is not settled after {} s</source>
        <translation>考虑摩擦和 {} {} 的控制量限值时，{} 的阶跃在 {} s 后仍未稳定</translation>
    </message>
    <message>
        <source>stable above {} times these gains</source>
        <translation>高于这些增益的 {} 倍时稳定</translation>
    </message>
    <message>
        <source>stable below {} times these gains</source>
        <translation>低于这些增益的 {} 倍时稳定</translation>
    </message>
    <message>
        <source>no common factor on these gains gives stability: change their ratio</source>
        <translation>这些增益乘以任何公共系数都不稳定：请改变其比例</translation>
    </message>
    <message>
        <source>procedure {} for a single loop is not available for this device; nothing was armed</source>
        <translation>单回路流程 {} 不适用于此设备；未使能</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>请去掉其中一个</translation>
    </message>
    <message>
        <source>axis {} occurs twice in the model</source>
        <translation>模型中轴 {} 重复</translation>
    </message>
    <message>
        <source>the covariance contains &apos;{}&apos;, which is not a quantity of the model or occurs twice</source>
        <translation>协方差含有 &apos;{}&apos;，它不是模型的量或重复出现</translation>
    </message>
    <message>
        <source>axis {}: unknown {}</source>
        <translation>轴 {}：{} 未知</translation>
    </message>
    <message>
        <source>axis {}: &quot;{}&quot; is not a position unit</source>
        <translation>轴 {}：&quot;{}&quot; 不是位置单位</translation>
    </message>
    <message>
        <source>use the unit of the axis</source>
        <translation>请使用该轴的单位</translation>
    </message>
    <message>
        <source>measured motion of axis {} outside the predicted band at {} s, by {} {}</source>
        <translation>轴 {} 的实测运动在 {} s 处超出预测范围 {} {}</translation>
    </message>
    <message>
        <source>Old values restored. Identify the axes again, or use lower gains.</source>
        <translation>已恢复旧值。请重新辨识各轴，或使用较低的增益。</translation>
    </message>
    <message>
        <source>motion of axis {} meanwhile: {} {}, allowed {} {}</source>
        <translation>期间轴 {} 的运动：{} {}，允许 {} {}</translation>
    </message>
    <message>
        <source>assess them with the model of those axes</source>
        <translation>请用这些轴的模型评估</translation>
    </message>
    <message>
        <source>use a higher frequency or more damping</source>
        <translation>请提高频率或增大阻尼</translation>
    </message>
    <message>
        <source>damping rate of this axis {} 1/s, above that of poles at {} rad/s with zeta = {}</source>
        <translation>此轴的阻尼率 {} 1/s，大于 {} rad/s、zeta = {} 的极点所需</translation>
    </message>
    <message>
        <source>linear-quadratic regulator, error and effort weights for the requested frequency</source>
        <translation>线性二次型调节器，误差和控制量按所需频率加权</translation>
    </message>
    <message>
        <source>fastest loop of this structure with the requested phase margin</source>
        <translation>该结构中满足所需相位裕度的最快回路</translation>
    </message>
    <message>
        <source>PID with the requested pole pair, set-point weight and filter</source>
        <translation>具有所需极点对、设定值权重和滤波器的 PID</translation>
    </message>
    <message>
        <source>recommended for this axis</source>
        <translation>推荐用于此轴</translation>
    </message>
    <message>
        <source>design method &apos;{}&apos; is not available for this axis</source>
        <translation>设计方法 &apos;{}&apos; 不适用于此轴</translation>
    </message>
    <message>
        <source>use 30 to 60 deg</source>
        <translation>请取 30 至 60 deg</translation>
    </message>
    <message>
        <source>no loop of this structure has a phase margin of {} deg on this axis</source>
        <translation>此轴上没有该结构的回路具有 {} deg 的相位裕度</translation>
    </message>
    <message>
        <source>check with tune --gains FILE --apply DEVICE; otherwise save the control law as C code</source>
        <translation>请用 tune --gains FILE --apply DEVICE 检查；否则将控制律存为 C 代码</translation>
    </message>
    <message>
        <source>these gains need a device whose control law has set-point weights and filters</source>
        <translation>这些增益需要控制律带设定值权重和滤波器的设备</translation>
    </message>
    <message>
        <source>remove it from the gains, or save the control law as C code for another controller</source>
        <translation>请从增益中去除，或将控制律存为 C 代码用于其他控制器</translation>
    </message>
    <message>
        <source>the control law of this device has no {}</source>
        <translation>此设备的控制律没有 {}</translation>
    </message>
    <message>
        <source>derivative filter</source>
        <translation>微分滤波</translation>
    </message>
    <message>
        <source>apply the gains in one step: this removes them</source>
        <translation>请一次应用增益：会将其去除</translation>
    </message>
    <message>
        <source>the device&apos;s control law has set-point weights or filters</source>
        <translation>设备的控制律含有设定值权重或滤波器</translation>
    </message>
    <message>
        <source>switch gradual applying off</source>
        <translation>请关闭逐步应用</translation>
    </message>
    <message>
        <source>gains with set-point weights or filters cannot be applied gradually</source>
        <translation>带设定值权重或滤波器的增益不能逐步应用</translation>
    </message>
    <message>
        <source>Use the magnet turned by 90 degrees about its shaft for the opposite polarity.</source>
        <translation>相反极性请用绕其轴转 90 度的磁体表示。</translation>
    </message>
    <message>
        <source>The coverage proof was stopped.</source>
        <translation>覆盖性证明已停止。</translation>
    </message>
    <message>
        <source>a section is defined by its sampled coefficients</source>
        <translation>二阶节由其采样系数定义</translation>
    </message>
    <message>
        <source>the motion does not separate the forces</source>
        <translation>该运动无法区分各力</translation>
    </message>
    <message>
        <source>model inadequate: the speed dependence of friction follows no known law</source>
        <translation>模型不充分：摩擦与转速的关系不符合已知规律</translation>
    </message>
    <message>
        <source>model inadequate: the damping changes during the recording</source>
        <translation>模型不充分：阻尼在记录过程中变化</translation>
    </message>
    <message>
        <source>phi is too small by up to a few per cent: calibrate the stray field, then identify again</source>
        <translation>phi 偏小可达百分之几：请标定杂散磁场，然后重新辨识</translation>
    </message>
    <message>
        <source>damping changes with the current: the torque angle depends on it, typical for a wrong stray-field compensation</source>
        <translation>阻尼随电流变化：转矩角与电流有关，通常由杂散磁场补偿错误引起</translation>
    </message>
    <message>
        <source>c, K_f and phi are valid at high speed without this term; near standstill friction is higher</source>
        <translation>c、K_f 和 phi 适用于高转速且不含此项；接近静止时摩擦更大</translation>
    </message>
    <message>
        <source>c, K_f and phi are given without this term; the tuning model has no quadratic drag</source>
        <translation>c、K_f 和 phi 不含此项；整定模型没有平方阻力</translation>
    </message>
    <message>
        <source>quadratic drag of the speed, {}</source>
        <translation>与转速平方成正比的阻力，{}</translation>
    </message>
    <message>
        <source>the intervals do not include this error: use the relevant speeds, warm up the bearings first, and check the residuals</source>
        <translation>区间不含此误差：请使用相关的转速，先使轴承预热，并检查残差</translation>
    </message>
    <message>
        <source>calibrate the sensors; check for an unreported delay</source>
        <translation>请标定传感器；检查未报告的时延</translation>
    </message>
    <message>
        <source>negative damping from the oscillation, not possible for a motor</source>
        <translation>由振荡得到的阻尼为负，电机不可能如此</translation>
    </message>
    <message>
        <source>as many unknowns as segments: the friction scatter between segments is assumed (3.3 % of the friction torque), not measured</source>
        <translation>未知量与段数相同：各段之间的摩擦离散按摩擦转矩的 3.3 % 假定，未实测</translation>
    </message>
    <message>
        <source>settling; final speed extrapolated</source>
        <translation>调节中；终值转速为外推</translation>
    </message>
    <message>
        <source>record again; allowed loss: one row in ten</source>
        <translation>请重新记录；允许丢失：每十行一行</translation>
    </message>
    <message>
        <source>no packet was lost or damaged: the device skipped or delayed rows</source>
        <translation>没有数据包丢失或损坏：设备跳过或延迟了数据</translation>
    </message>
    <message>
        <source>{} % of the frames were damaged on the line</source>
        <translation>线路上有 {} % 的帧损坏</translation>
    </message>
    <message>
        <source>the device clock restarted: the recording has a gap, measured with the computer clock</source>
        <translation>设备时钟重新启动：记录有间断，按计算机时钟计量</translation>
    </message>
    <message>
        <source>valid if the rotor turns by less than half of this angle between two rows</source>
        <translation>前提是两行之间转子转角小于该值的一半</translation>
    </message>
    <message>
        <source>angle wraps after {} deg: unwrapped</source>
        <translation>角度每 {} deg 折返：已展开</translation>
    </message>
    <message>
        <source>the angle column looks like a speed: it settles with each current</source>
        <translation>角度列像是转速：随每个电流趋于稳定</translation>
    </message>
    <message>
        <source>use larger and more different currents, each for a longer time</source>
        <translation>请使用更大、差异更大的电流，并延长每个电流的时间</translation>
    </message>
    <message>
        <source>the interval of torque constant or inertia includes zero</source>
        <translation>转矩常数或惯量的区间包含零</translation>
    </message>
    <message>
        <source>negative inertia, not possible for a rotor</source>
        <translation>惯量为负，转子不可能如此</translation>
    </message>
    <message>
        <source>negative torque constant: the current accelerates the rotor backwards</source>
        <translation>转矩常数为负：电流使转子反向加速</translation>
    </message>
    <message>
        <source>current and angle are not consistent: check units, time shift of the columns, and that nothing else drives the rotor</source>
        <translation>电流与角度不一致：请检查单位、各列的时间偏移，并确认没有其他力驱动转子</translation>
    </message>
    <message>
        <source>damping undetermined: between zero and {} % of the largest torque</source>
        <translation>阻尼无法确定：在零与最大转矩的 {} % 之间</translation>
    </message>
    <message>
        <source>damping not distinguishable from zero: at most {} % of the torque</source>
        <translation>阻尼与零无法区分：至多为转矩的 {} %</translation>
    </message>
    <message>
        <source>friction undetermined: between zero and {} % of the largest torque</source>
        <translation>摩擦无法确定：在零与最大转矩的 {} % 之间</translation>
    </message>
    <message>
        <source>friction not distinguishable from zero: at most {} % of the torque</source>
        <translation>摩擦与零无法区分：至多为转矩的 {} %</translation>
    </message>
    <message>
        <source>negative friction, not possible for a motor</source>
        <translation>摩擦为负，电机不可能如此</translation>
    </message>
    <message>
        <source>invert the sign of one of the two columns (or of the command on the device), then identify again</source>
        <translation>请反转其中一列（或设备指令）的符号，然后重新辨识</translation>
    </message>
    <message>
        <source>check the loop delay and that nothing else drives the rotor</source>
        <translation>请检查回路时延，并确认没有其他力驱动转子</translation>
    </message>
    <message>
        <source>negative damping, not possible for a motor</source>
        <translation>阻尼为负，电机不可能如此</translation>
    </message>
    <message>
        <source>the interval of phi/J includes zero</source>
        <translation>phi/J 的区间包含零</translation>
    </message>
    <message>
        <source>invert one of the two signs on the device, then measure again</source>
        <translation>请在设备上反转其中一个符号，然后重新测量</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: negative torque constant</source>
        <translation>电流或角度符号错误：转矩常数为负</translation>
    </message>
    <message>
        <source>identify the motor with the present delay of the device</source>
        <translation>请按设备当前的时延辨识电机</translation>
    </message>
    <message>
        <source>use a faster loop, or one with more integral action</source>
        <translation>请采用更快的回路，或积分作用更强的回路</translation>
    </message>
    <message>
        <source>with friction and current limit a step of {} deg is not settled after {} s: overshoot unknown</source>
        <translation>考虑摩擦和电流限值时，{} deg 的阶跃在 {} s 后仍未稳定：超调未知</translation>
    </message>
    <message>
        <source>use gains with faster poles, or a longer sampling period</source>
        <translation>请使用极点更快的增益，或更长的采样周期</translation>
    </message>
    <message>
        <source>no figures of the step: its slowest part decays by {} per sample, too slow to simulate</source>
        <translation>阶跃没有指标：其最慢部分每个采样衰减 {}，过慢而无法仿真</translation>
    </message>
    <message>
        <source>what-if needs a sampling period of whole milliseconds</source>
        <translation>假设分析需要整毫秒的采样周期</translation>
    </message>
    <message>
        <source>a step of {} s cannot be simulated with a sampling period of {} s</source>
        <translation>无法以 {} s 的时长、{} s 的采样周期仿真阶跃</translation>
    </message>
    <message>
        <source>the file is not changed; move &apos;{}&apos; away to read the data without checksum</source>
        <translation>文件未改变；移走 &apos;{}&apos; 后可不经校验读取数据</translation>
    </message>
    <message>
        <source>the file is not changed: its content can be read as text</source>
        <translation>文件未改变：其内容可按文本读取</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no undamaged row</source>
        <translation>&apos;{}&apos; 没有完好的行</translation>
    </message>
    <message>
        <source>one signal at {} Hz is not possible: maximum of device and link {} Hz</source>
        <translation>1 个信号无法达到 {} Hz：设备和链路的最大值为 {} Hz</translation>
    </message>
    <message>
        <source>omit it to use these gains; weights and filters are assessed by &apos;halbench analyse&apos; and &apos;halbench tune --gains&apos;</source>
        <translation>去掉它即可使用这些增益；权重和滤波器由 &apos;halbench analyse&apos; 和 &apos;halbench tune --gains&apos; 评估</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a display unit of this signal; available: {}</source>
        <translation>&apos;{}&apos; 不是该信号的显示单位；可用：{}</translation>
    </message>
    <message>
        <source>{} filters exceed the maximum of {}</source>
        <translation>{} 个滤波器超过上限 {}</translation>
    </message>
    <message>
        <source>add integral action, or use b = 1</source>
        <translation>请加入积分作用，或取 b = 1</translation>
    </message>
    <message>
        <source>without integral action the set-point weight b = {} gives a final value of {} times the reference</source>
        <translation>无积分作用时，设定值权重 b = {} 使终值为参考值的 {} 倍</translation>
    </message>
    <message>
        <source>editing markers needs a recording with a .meta.json file</source>
        <translation>编辑标记需要带 .meta.json 文件的记录</translation>
    </message>
    <message>
        <source>another program is changing &apos;{}&apos;</source>
        <translation>其他程序正在更改 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>not available in the device&apos;s control law</source>
        <translation>设备的控制律不支持</translation>
    </message>
    <message>
        <source>use a lower rate or fewer signals</source>
        <translation>请降低速率或减少信号</translation>
    </message>
    <message>
        <source>use a lower rate or fewer signals; for a port that is USB up to the device, give its real speed in the address with ?baud=12000000</source>
        <translation>请降低速率或减少信号；若端口到设备全程为 USB，请在地址中用 ?baud=12000000 给出实际速度</translation>
    </message>
    <message>
        <source>{} signals at {} Hz are not possible: maximum of device and link {} Hz</source>
        <translation>{} 个信号无法达到 {} Hz：设备和链路的最大值为 {} Hz</translation>
    </message>
    <message>
        <source>check their findings</source>
        <translation>请查看诊断</translation>
    </message>
    <message>
        <source>these gains are rejected; nothing was written</source>
        <translation>这些增益被拒绝；未写入任何内容</translation>
    </message>
    <message>
        <source>gains for {} s and {} samples of delay, this device has {} s and {}: assessed for this device</source>
        <translation>增益针对 {} s 和 {} 个采样时延，此设备为 {} s 和 {}：按此设备评估</translation>
    </message>
    <message>
        <source>compare gains of the same device</source>
        <translation>请比较同一设备的增益</translation>
    </message>
    <message>
        <source>{}: the recorded gains have another sampling period</source>
        <translation>{}：记录时的增益采样周期不同</translation>
    </message>
    <message>
        <source>record a move with constant gains</source>
        <translation>请在增益不变的情况下记录一次运动</translation>
    </message>
    <message>
        <source>{}: the gains during the recording are not in its .meta.json file</source>
        <translation>{}：其 .meta.json 文件中没有记录时的增益</translation>
    </message>
    <message>
        <source>the date is uncertain (check the clock)</source>
        <translation>日期不确定（请检查时钟）</translation>
    </message>
    <message>
        <source>oscillation around a steady motion</source>
        <translation>围绕匀速运动振荡</translation>
    </message>
    <message>
        <source>identify the motor and give its model: the plan was computed for another motor</source>
        <translation>请辨识电机并给出其模型：该计划是为另一台电机计算的</translation>
    </message>
    <message>
        <source>speed of the rotor {} rad/s, expected {}</source>
        <translation>转子转速 {} rad/s，预期 {}</translation>
    </message>
    <message>
        <source>calibrate the sensors and apply the calibration, use the model of this motor, or a smaller relay amplitude</source>
        <translation>请标定传感器并应用标定，使用此电机的模型，或减小继电幅值</translation>
    </message>
    <message>
        <source>omit base speed and relay amplitude, allow a higher speed or more current, or use the model of this motor</source>
        <translation>请不指定基础转速和继电幅值，或允许更高转速或更大电流，或使用此电机的模型</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s allows an oscillation of {} rad without nearing standstill</source>
        <translation>{} 至 {} rad/s 的基础转速都无法产生 {} rad 的振荡而不接近静止</translation>
    </message>
    <message>
        <source>at a base speed of {} rad/s no relay gives an oscillation of {} rad without nearing standstill or {} rad/s</source>
        <translation>基础转速 {} rad/s 时，任何继电幅值都无法产生 {} rad 的振荡而不接近静止或 {} rad/s</translation>
    </message>
    <message>
        <source>relay gain in A/rad</source>
        <translation>继电增益 (A/rad)</translation>
    </message>
    <message>
        <source>relay amplitude in A</source>
        <translation>继电幅值 (A)</translation>
    </message>
    <message>
        <source>not compared with a model of this motor</source>
        <translation>未与此电机的模型比较</translation>
    </message>
    <message>
        <source>agreement with the model unknown: the model has no covariance</source>
        <translation>与模型是否一致未知：模型没有协方差</translation>
    </message>
    <message>
        <source>identify the motor again: it changed, or one of the results is wrong</source>
        <translation>请重新辨识电机：电机已改变，或其中一个结果有误</translation>
    </message>
    <message>
        <source>ultimate gain of the model {} to {} A/rad, measured {} to {}</source>
        <translation>模型的临界增益 {} 至 {} A/rad，实测 {} 至 {}</translation>
    </message>
    <message>
        <source>uncertainty of the ultimate gain {} %</source>
        <translation>临界增益的不确定度 {} %</translation>
    </message>
    <message>
        <source>ultimate gain between {} and {} A/rad: too uncertain</source>
        <translation>临界增益在 {} 与 {} A/rad 之间：不确定度过大</translation>
    </message>
    <message>
        <source>measure more cycles or use a larger relay gain; calibrate the sensors first</source>
        <translation>请测量更多次振荡，或增大继电增益；请先标定传感器</translation>
    </message>
    <message>
        <source>amplitude change of the oscillation {} % from the first third to the last</source>
        <translation>振荡幅值从前三分之一到后三分之一变化 {} %</translation>
    </message>
    <message>
        <source>calibrate the sensors, apply the calibration, then measure again</source>
        <translation>请标定传感器并应用标定，然后重新测量</translation>
    </message>
    <message>
        <source>frequency drift of the oscillation {} %: excited by angle errors during rotation, allowed {} %</source>
        <translation>振荡频率漂移 {} %：由转动中的角度误差引起，允许 {} %</translation>
    </message>
    <message>
        <source>rows missing: the cycles are not consistent</source>
        <translation>缺少数据：各次振荡不一致</translation>
    </message>
    <message>
        <source>allowed: {} deg; check for an unreported delay or a resonance</source>
        <translation>允许 {} deg；请检查未报告的时延或共振</translation>
    </message>
    <message>
        <source>phase at the oscillation frequency {} deg, too far from -180 deg</source>
        <translation>振荡频率处的相位为 {} deg，离 -180 deg 太远</translation>
    </message>
    <message>
        <source>no ultimate gain exists; use a method with derivative action</source>
        <translation>不存在临界增益；请使用带微分作用的方法</translation>
    </message>
    <message>
        <source>this motor has no damping: proportional control oscillates at any gain</source>
        <translation>此电机无阻尼：比例控制在任何增益下都振荡</translation>
    </message>
    <message>
        <source>use a larger relay gain, or the model of this motor</source>
        <translation>请增大继电增益，或使用此电机的模型</translation>
    </message>
    <message>
        <source>only {} cycles in the recording: no limit cycle</source>
        <translation>记录中只有 {} 次振荡：不是极限环</translation>
    </message>
    <message>
        <source>check the recording for an angle error or a resonance</source>
        <translation>请检查记录中的角度误差或共振</translation>
    </message>
    <message>
        <source>the oscillation does not match a rotor</source>
        <translation>振荡与转子不符</translation>
    </message>
    <message>
        <source>a row of the cycle contains a value that is not a number</source>
        <translation>振荡数据中含有非数字的值</translation>
    </message>
    <message>
        <source>the rows of the oscillation are not three signals of equal length</source>
        <translation>振荡数据不是三个等长信号</translation>
    </message>
    <message>
        <source>give both from the relay experiment, or omit both</source>
        <translation>请同时给出继电实验的两个值，或都不给出</translation>
    </message>
    <message>
        <source>ultimate gain and ultimate period must be given together</source>
        <translation>临界增益和临界周期必须同时给出</translation>
    </message>
    <message>
        <source>use a different name for each column</source>
        <translation>请为每列使用不同的名称</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not allowed as a signal name</source>
        <translation>&apos;{}&apos; 不能作为信号名</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not allowed as a signal name: it is the time</source>
        <translation>&apos;{}&apos; 不能作为信号名：它是时间</translation>
    </message>
    <message>
        <source>use small steps only, or a smaller K_P</source>
        <translation>请只用小阶跃，或减小 K_P</translation>
    </message>
    <message>
        <source>{} grows into a limit cycle of about +-{} deg at {} Hz</source>
        <translation>{} 会增长为约 +-{} deg、{} Hz 的极限环</translation>
    </message>
    <message>
        <source>an oscillation above +-{} deg</source>
        <translation>超过 +-{} deg 的振荡</translation>
    </message>
    <message>
        <source>use a lower value, or omit it</source>
        <translation>请使用更小的值，或不指定</translation>
    </message>
    <message>
        <source>the target current-limit-a = {} is above the device limit of {} A</source>
        <translation>目标 current-limit-a = {} 超过设备限值 {} A</translation>
    </message>
    <message>
        <source>no gains with at most {} A in a step of {} deg found for this motor; required: {} A</source>
        <translation>未找到此电机电流至多 {} A（{} deg 阶跃）的增益；需要：{} A</translation>
    </message>
    <message>
        <source>no gains with a sensitivity peak up to {} found for this motor; minimum: {}</source>
        <translation>未找到此电机灵敏度峰值不超过 {} 的增益；最小值：{}</translation>
    </message>
    <message>
        <source>give the current limit for this step</source>
        <translation>请给出此阶跃的电流限值</translation>
    </message>
    <message>
        <source>give the largest step without saturation, in degrees</source>
        <translation>请给出不饱和的最大阶跃（度）</translation>
    </message>
    <message>
        <source>give the maximum current of the motor in A</source>
        <translation>请给出电机的最大电流（A）</translation>
    </message>
    <message>
        <source>1.4 is robust, 1.7 usual, 2 fast</source>
        <translation>1.4 稳健，1.7 常用，2 快速</translation>
    </message>
    <message>
        <source>minimum integral of the absolute error after a load step, with limits on Ms and current</source>
        <translation>负载阶跃后绝对误差积分最小，并限制 Ms 和电流</translation>
    </message>
    <message>
        <source>empty the trash; on a disk without trash use `halbench recordings --retain ... --delete` to delete permanently</source>
        <translation>请清空回收站；若磁盘没有回收站，可用 `halbench recordings --retain ... --delete` 永久删除</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be moved to the trash</source>
        <translation>无法将 &apos;{}&apos; 移到回收站</translation>
    </message>
    <message>
        <source>move running</source>
        <translation>正在运动</translation>
    </message>
    <message>
        <source>position hold</source>
        <translation>位置保持</translation>
    </message>
    <message>
        <source>it is checked again next time</source>
        <translation>下次将再次检查</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is kept: {}</source>
        <translation>保留 &apos;{}&apos;：{}</translation>
    </message>
    <message>
        <source>its data were changed</source>
        <translation>其数据已改变</translation>
    </message>
    <message>
        <source>it is less than 24 hours old</source>
        <translation>不到 24 小时</translation>
    </message>
    <message>
        <source>another file has the same name</source>
        <translation>另一文件同名</translation>
    </message>
    <message>
        <source>invalid limit &apos;{}&apos; for --retain</source>
        <translation>--retain 的限值 &apos;{}&apos; 无效</translation>
    </message>
    <message>
        <source>use e.g. --retain 30d, --retain 20GB or --retain 30d,20GB</source>
        <translation>例如 --retain 30d、--retain 20GB 或 --retain 30d,20GB</translation>
    </message>
    <message>
        <source>shorten the name or the mask to {} bytes</source>
        <translation>请将名称或模板缩短到 {} 字节</translation>
    </message>
    <message>
        <source>the name of the recording would have {} bytes</source>
        <translation>记录的名称将有 {} 字节</translation>
    </message>
    <message>
        <source>omit .csv</source>
        <translation>请去掉 .csv</translation>
    </message>
    <message>
        <source>the file extension is added automatically</source>
        <translation>文件扩展名会自动添加</translation>
    </message>
    <message>
        <source>a name cannot begin with a space or a dot</source>
        <translation>名称不能以空格或点开头</translation>
    </message>
    <message>
        <source>example: {}</source>
        <translation>示例：{}</translation>
    </message>
    <message>
        <source>use {number} only once</source>
        <translation>{number} 只用一次</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not allowed in file names</source>
        <translation>文件名中不允许 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>enter the folder in its own field</source>
        <translation>请在文件夹栏中输入</translation>
    </message>
    <message>
        <source>a name cannot contain a folder</source>
        <translation>名称中不能包含文件夹</translation>
    </message>
    <message>
        <source>&apos;}&apos; without &apos;{&apos;</source>
        <translation>&apos;}&apos; 缺少 &apos;{&apos;</translation>
    </message>
    <message>
        <source>&apos;{&apos; without &apos;}&apos;</source>
        <translation>&apos;{&apos; 缺少 &apos;}&apos;</translation>
    </message>
    <message>
        <source>allowed are {device}, {name}, {date}, {time} and {number}</source>
        <translation>允许 {device}、{name}、{date}、{time} 和 {number}</translation>
    </message>
    <message>
        <source>apply them gradually, or use gains with a larger modulus margin</source>
        <translation>请逐步应用，或使用模裕度更大的增益</translation>
    </message>
    <message>
        <source>these gains amplify model errors {} times more than the recorded gains: the band is wider by this factor</source>
        <translation>这些增益对模型误差的放大是记录时增益的 {} 倍：范围按此倍数放宽</translation>
    </message>
    <message>
        <source>use stable gains</source>
        <translation>请使用稳定的增益</translation>
    </message>
    <message>
        <source>the loop is unstable with these gains: no prediction</source>
        <translation>采用这些增益时回路不稳定：无预测</translation>
    </message>
    <message>
        <source>no prediction for other gains: identify the motor again, or use a recording of this motor with these gains</source>
        <translation>无法预测其他增益：请重新辨识电机，或使用此电机采用这些增益的记录</translation>
    </message>
    <message>
        <source>the band is widened to contain the recording; identify the motor again for a better one</source>
        <translation>范围已放宽以包含该记录；如需更好的结果，请重新辨识电机</translation>
    </message>
    <message>
        <source>the model with the recorded gains does not match the recorded move: {} % outside the predicted band</source>
        <translation>采用记录时增益的模型与记录的运动不符：{} % 超出预测范围</translation>
    </message>
    <message>
        <source>a replay needs position, reference and current_command</source>
        <translation>回放需要 position、reference 和 current_command</translation>
    </message>
    <message>
        <source>use a recording that begins with its move, as `halbench move --out` writes it</source>
        <translation>请使用从运动开始处记录的数据，如 `halbench move --out` 所写</translation>
    </message>
    <message>
        <source>the rotor is already moving when the recording begins</source>
        <translation>记录开始时转子已在运动</translation>
    </message>
    <message>
        <source>rows missing at {} s: no prediction possible</source>
        <translation>{} s 处缺少数据：无法预测</translation>
    </message>
    <message>
        <source>no valid motor within the model&apos;s uncertainty</source>
        <translation>模型不确定度范围内没有有效的电机</translation>
    </message>
    <message>
        <source>more than 5 % of the measured motion outside the predicted band</source>
        <translation>超过 5 % 的实测运动超出预测范围</translation>
    </message>
    <message>
        <source>allow larger steps, or apply intermediate gains first</source>
        <translation>请允许更大的步长，或先应用中间的增益</translation>
    </message>
    <message>
        <source>the gains are more than 40 steps away</source>
        <translation>目标增益需要超过 40 步</translation>
    </message>
    <message>
        <source>a step factor of {} is too small</source>
        <translation>步长系数 {} 太小</translation>
    </message>
    <message>
        <source>nothing was written; use gains with larger margins, or identify more precisely</source>
        <translation>未写入任何内容；请使用裕度更大的增益，或更精确地辨识</translation>
    </message>
    <message>
        <source>step {} of {} is not safe: unstable for {} % of the motors within the uncertainty, margins {} deg and {}</source>
        <translation>第 {}/{} 步不安全：不确定度范围内 {} % 的电机不稳定，裕度 {} deg 和 {}</translation>
    </message>
    <message>
        <source>measured motion outside the predicted band at {} s, by {} degrees</source>
        <translation>实测运动在 {} s 处超出预测范围 {} 度</translation>
    </message>
    <message>
        <source>wait until a picture is shown</source>
        <translation>请等待图片显示</translation>
    </message>
    <message>
        <source>check that the file exists</source>
        <translation>请检查文件是否存在</translation>
    </message>
    <message>
        <source>{}: the file exists already</source>
        <translation>{}：文件已存在</translation>
    </message>
    <message>
        <source>positions in the .meta.json file</source>
        <translation>位置见 .meta.json 文件</translation>
    </message>
    <message>
        <source>times are not changed; functions that need a constant rate may reject the recording</source>
        <translation>时间不变；需要恒定速率的功能可能拒绝该记录</translation>
    </message>
    <message>
        <source>uneven time steps: {} s to {} s</source>
        <translation>时间步长不均匀：{} s 至 {} s</translation>
    </message>
    <message>
        <source>give its unit with --unit</source>
        <translation>请用 --unit 给出单位</translation>
    </message>
    <message>
        <source>unknown unit &apos;{}&apos; of column &apos;{}&apos;: numbers are kept without a unit</source>
        <translation>单位 &apos;{}&apos; 未知（&apos;{}&apos; 列）：数值保留，不带单位</translation>
    </message>
    <message>
        <source>--time and --rate_Hz exclude each other</source>
        <translation>--time 与 --rate_Hz 互斥</translation>
    </message>
    <message>
        <source>give the sampling rate in rows per second</source>
        <translation>请给出采样率（每秒行数）</translation>
    </message>
    <message>
        <source>numbers range from about 1e-308 to 1e308</source>
        <translation>数值范围约为 1e-308 至 1e308</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is out of the number range</source>
        <translation>&apos;{}&apos; 超出数值范围</translation>
    </message>
    <message>
        <source>{}:1:1: lines end with CR only</source>
        <translation>{}:1:1：行仅以 CR 结尾</translation>
    </message>
    <message>
        <source>zero bytes: not a text file</source>
        <translation>含零字节：不是文本文件</translation>
    </message>
    <message>
        <source>a table has rows of equal length, up to two lines of names and units above, and comments beginning with #; set the format with --separator, --decimal and --header</source>
        <translation>表格各行列数相同，上方至多两行名称和单位，注释以 # 开头；用 --separator、--decimal 和 --header 指定格式</translation>
    </message>
    <message>
        <source>write numbers without thousands separators</source>
        <translation>数字中请勿使用千位分隔符</translation>
    </message>
    <message>
        <source>line {} may be a row of numbers or of {}</source>
        <translation>第 {} 行可能是数字或 {}</translation>
    </message>
    <message>
        <source> (thousands separators are not supported: remove them)</source>
        <translation>（不支持千位分隔符：请去除）</translation>
    </message>
    <message>
        <source>the format of columns and numbers is uncertain</source>
        <translation>列和数字的格式不确定</translation>
    </message>
    <message>
        <source>choose the time column with --time, or give --rate_Hz</source>
        <translation>请用 --time 选择时间列，或给出 --rate_Hz</translation>
    </message>
    <message>
        <source>map another column with --map, or give its unit with --unit</source>
        <translation>请用 --map 映射其他列，或用 --unit 给出单位</translation>
    </message>
    <message>
        <source>choose another column with --time, or give its unit with --unit</source>
        <translation>请用 --time 选择其他列，或用 --unit 给出单位</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is in {}, which is not a time unit</source>
        <translation>&apos;{}&apos; 列的单位为 {}，不是时间单位</translation>
    </message>
    <message>
        <source>unit of its numbers: {}</source>
        <translation>其数字的单位：{}</translation>
    </message>
    <message>
        <source>the unit of column &apos;{}&apos; is unknown</source>
        <translation>&apos;{}&apos; 列的单位未知</translation>
    </message>
    <message>
        <source>no time column: F rows per second</source>
        <translation>无时间列：每秒 F 行</translation>
    </message>
    <message>
        <source>the time column is uncertain</source>
        <translation>时间列不确定</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a known unit</source>
        <translation>&apos;{}&apos; 不是已知单位</translation>
    </message>
    <message>
        <source>the model has no covariance: its uncertainty is unknown</source>
        <translation>模型没有协方差：其不确定度未知</translation>
    </message>
    <message>
        <source>no gain margin: the magnitude at the phase crossover is completely uncertain</source>
        <translation>无幅值裕度：相位穿越处的幅值完全不确定</translation>
    </message>
    <message>
        <source>no phase margin: the phase at the gain crossover is completely uncertain</source>
        <translation>无相位裕度：增益穿越处的相位完全不确定</translation>
    </message>
    <message>
        <source>waiting for the last rows</source>
        <translation>等待最后的数据</translation>
    </message>
    <message>
        <source>sweep from {} to {} Hz, {} of {}</source>
        <translation>扫描 {} 至 {} Hz，{}/{}</translation>
    </message>
    <message>
        <source>the generator of this device has neither multisine nor chirp</source>
        <translation>此设备的发生器既无多正弦也无扫频</translation>
    </message>
    <message>
        <source>scroll to a range with samples, or move the cursors</source>
        <translation>请滚动到有样本的范围，或移动光标</translation>
    </message>
    <message>
        <source>no samples of the plots in this time range</source>
        <translation>此时间范围内曲线图没有样本</translation>
    </message>
    <message>
        <source>zoom in, move the cursors closer, or record and cut with halbench convert</source>
        <translation>请放大、缩小光标间距，或记录后用 halbench convert 截取</translation>
    </message>
    <message>
        <source>{} values exceed the limit for data from the plots</source>
        <translation>{} 个值超过曲线图导出的限制</translation>
    </message>
    <message>
        <source>a sweep is too short to resolve its frequencies</source>
        <translation>扫描太短，无法分辨各频率</translation>
    </message>
    <message>
        <source>a swept row contains a value that is not a number</source>
        <translation>扫描数据中含有非数字的值</translation>
    </message>
    <message>
        <source>{} sweeps are too few to estimate the scatter</source>
        <translation>{} 次扫描太少，无法估计离散</translation>
    </message>
    <message>
        <source>the swept rows are not complete sweeps of three signals</source>
        <translation>扫描数据不是三个信号的完整扫描</translation>
    </message>
    <message>
        <source>axes can be moved one at a time only</source>
        <translation>各轴只能逐一运动</translation>
    </message>
    <message>
        <source>the device has several axes; no axis selected</source>
        <translation>设备有多个轴；未选择轴</translation>
    </message>
    <message>
        <source>Old values restored. Check that the link is not overloaded, then apply again.</source>
        <translation>已恢复旧值。请检查链路是否过载，然后再次应用。</translation>
    </message>
    <message>
        <source>only {} of {} s of the verification move were recorded</source>
        <translation>验证运动只记录了 {}/{} s</translation>
    </message>
    <message>
        <source>no crossover gives a stable position loop for this motor</source>
        <translation>没有穿越频率能使此电机的位置环稳定</translation>
    </message>
    <message>
        <source>unknown capture state of the device</source>
        <translation>设备的捕获状态未知</translation>
    </message>
    <message>
        <source>the device sent no data of its completed capture</source>
        <translation>设备未发送已完成捕获的数据</translation>
    </message>
    <message>
        <source>make sure that no other program uses it, then re-arm the trigger</source>
        <translation>请确认没有其他程序使用，然后重新准备触发</translation>
    </message>
    <message>
        <source>the device&apos;s capture was ended by another program</source>
        <translation>设备的捕获被其他程序结束</translation>
    </message>
    <message>
        <source>the recording of a stream needs a level trigger</source>
        <translation>数据流的记录需要电平触发</translation>
    </message>
    <message>
        <source>split the file; each part begins with its first line</source>
        <translation>请拆分文件；每部分都以其首行开头</translation>
    </message>
    <message>
        <source>the file may be damaged or not a recording</source>
        <translation>文件可能损坏或不是记录</translation>
    </message>
    <message>
        <source>the oldest samples are dropped when memory is full; recordings are not affected; check the folder and the disk</source>
        <translation>内存满时丢弃最旧的样本；不影响记录；请检查文件夹和磁盘</translation>
    </message>
    <message>
        <source>the oldest samples are dropped earlier; recordings are not affected; free disk space</source>
        <translation>最旧的样本会更早丢弃；不影响记录；请释放磁盘空间</translation>
    </message>
    <message>
        <source>no space for more history in &apos;{}&apos;: {}</source>
        <translation>&apos;{}&apos; 中没有空间保存更多历史：{}</translation>
    </message>
    <message>
        <source>a gap is shown instead; recordings are not affected; check the disk</source>
        <translation>该处显示为间断；不影响记录；请检查磁盘</translation>
    </message>
    <message>
        <source>the history in &apos;{}&apos; cannot be read: {}</source>
        <translation>无法读取 &apos;{}&apos; 中的历史：{}</translation>
    </message>
    <message>
        <source>use a smaller lowest frequency; the period becomes longer</source>
        <translation>请降低最低频率，使周期更长</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s separates the harmonics of the rotation from the lines: a period is only {} s</source>
        <translation>{} 至 {} rad/s 的基础转速都无法将转动谐波与谱线分开：一个周期仅 {} s</translation>
    </message>
    <message>
        <source>measure the response on this device</source>
        <translation>请在此设备上测量响应</translation>
    </message>
    <message>
        <source>sampling period of the response {} ms, of this loop {} ms</source>
        <translation>响应的采样周期为 {} ms，此回路为 {} ms</translation>
    </message>
    <message>
        <source>{}: points: the list is empty</source>
        <translation>{}：points：列表为空</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs a plant, and a frequency above the previous one and below half the rate</source>
        <translation>{}：points[{}]：需要对象，且频率须大于前一点并小于速率的一半</translation>
    </message>
    <message>
        <source>check its findings, then measure again</source>
        <translation>请查看诊断，然后重新测量</translation>
    </message>
    <message>
        <source>{}: this response was rejected</source>
        <translation>{}：此响应被拒绝</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} numbers, too many for the comparison</source>
        <translation>&apos;{}&apos; 有 {} 个数值，超出比较的限制</translation>
    </message>
    <message>
        <source>tags and notes need a recording with a .meta.json file</source>
        <translation>标签和备注需要带 .meta.json 文件的记录</translation>
    </message>
    <message>
        <source>use a start time before the end</source>
        <translation>请使用结束之前的起始时间</translation>
    </message>
    <message>
        <source>use one result; the comma separates function arguments</source>
        <translation>请只用一个结果；逗号用于分隔函数参数</translation>
    </message>
    <message>
        <source>split it: a derived signal may use the derived signals before it</source>
        <translation>请拆分：派生信号可使用其前面的派生信号</translation>
    </message>
    <message>
        <source>the expression has more than {} characters</source>
        <translation>表达式超过 {} 个字符</translation>
    </message>
    <message>
        <source>use == to compare</source>
        <translation>比较请用 ==</translation>
    </message>
    <message>
        <source>column {} of the expression: = is not an operator</source>
        <translation>表达式第 {} 列：= 不是运算符</translation>
    </message>
    <message>
        <source>column {} of the expression: unexpected &apos;{}&apos;</source>
        <translation>表达式第 {} 列：意外的 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>column {} of the expression: too few arguments for {}</source>
        <translation>表达式第 {} 列：{} 的参数过少</translation>
    </message>
    <message>
        <source>column {} of the expression: too many arguments for {}</source>
        <translation>表达式第 {} 列：{} 的参数过多</translation>
    </message>
    <message>
        <source>every ? needs a :</source>
        <translation>每个 ? 都需要 :</translation>
    </message>
    <message>
        <source>column {} of the expression: missing :</source>
        <translation>表达式第 {} 列：缺少 :</translation>
    </message>
    <message>
        <source>close every (</source>
        <translation>每个 ( 都要闭合</translation>
    </message>
    <message>
        <source>column {} of the expression: missing )</source>
        <translation>表达式第 {} 列：缺少 )</translation>
    </message>
    <message>
        <source>column {} of the expression: unexpected end</source>
        <translation>表达式第 {} 列：意外结束</translation>
    </message>
    <message>
        <source>give the unit of the result, 1 for a number; terms of a sum need equal units</source>
        <translation>请给出结果的单位，纯数为 1；相加的各项单位须相同</translation>
    </message>
    <message>
        <source>the unit of the expression cannot be determined</source>
        <translation>无法确定表达式的单位</translation>
    </message>
    <message>
        <source>column {} of the expression: unknown signal &apos;{}&apos;</source>
        <translation>表达式第 {} 列：未知信号 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>use signal names as in recordings, e.g. current.a</source>
        <translation>请使用记录中的信号名，例如 current.a</translation>
    </message>
    <message>
        <source>the expression contains no signal</source>
        <translation>表达式中没有信号</translation>
    </message>
    <message>
        <source>use letters, digits, dots and underscores; begin with a letter or underscore</source>
        <translation>请使用字母、数字、点和下划线；以字母或下划线开头</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a valid signal name</source>
        <translation>&apos;{}&apos; 不是有效的信号名</translation>
    </message>
    <message>
        <source>unknown excitation &apos;{}&apos;</source>
        <translation>未知激励 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the device uses the printed difference equation, which has no gains</source>
        <translation>设备使用刊载的差分方程，没有增益</translation>
    </message>
    <message>
        <source>excitation from {} Hz</source>
        <translation>激励自 {} Hz 起</translation>
    </message>
    <message>
        <source>running up</source>
        <translation>升速中</translation>
    </message>
    <message>
        <source>use a smaller amplitude or a higher base speed; if the loop oscillates by itself, use gains with more damping first</source>
        <translation>请减小幅值或提高基础转速；若回路自激振荡，请先使用阻尼更大的增益</translation>
    </message>
    <message>
        <source>the speed fell to {} rad/s at a base speed of {} rad/s: near standstill friction is not a constant offset</source>
        <translation>转速降到 {} rad/s（基础转速 {} rad/s）：接近静止时摩擦不是恒定偏置</translation>
    </message>
    <message>
        <source>use at most {} deg, a higher base speed or fewer high frequencies, or omit the amplitude</source>
        <translation>请至多用 {} deg，提高基础转速或减少高频，或不指定幅值</translation>
    </message>
    <message>
        <source>an amplitude of {} deg changes the reference speed by {} rad/s at a base speed of {} rad/s: the speed would change its sign</source>
        <translation>幅值 {} deg 使参考转速变化 {} rad/s，而基础转速为 {} rad/s：转速会变号</translation>
    </message>
    <message>
        <source>a base speed of {} rad/s is too low: friction is a constant offset only during rotation</source>
        <translation>基础转速 {} rad/s 太低：只有转动时摩擦才是恒定偏置</translation>
    </message>
    <message>
        <source>minimum coherence</source>
        <translation>最小相干性</translation>
    </message>
    <message>
        <source>the intervals are widened by this factor; check for a resonance or an angle error</source>
        <translation>区间已按此倍数放宽；请检查共振或角度误差</translation>
    </message>
    <message>
        <source>distance of the points from the fitted rotor: {} times their scatter</source>
        <translation>各点与拟合转子的距离：其离散的 {} 倍</translation>
    </message>
    <message>
        <source>the points do not determine the constants of a rotor</source>
        <translation>这些点无法确定转子常数</translation>
    </message>
    <message>
        <source>switch stray.enabled on: the measured loop includes it</source>
        <translation>请开启 stray.enabled：所测回路包含该补偿</translation>
    </message>
    <message>
        <source>stray-field compensation was on during the measurement, but is off on the device</source>
        <translation>测量时杂散磁场补偿已开启，但设备上为关闭</translation>
    </message>
    <message>
        <source>the current reached its limit of {} A: the plant is valid, the closed loop was not linear</source>
        <translation>电流达到 {} A 的限值：对象有效，闭环非线性</translation>
    </message>
    <message>
        <source>use more periods or a larger amplitude</source>
        <translation>请增加周期数或增大幅值</translation>
    </message>
    <message>
        <source>{} of {} frequencies have a coherence below {} and were excluded</source>
        <translation>{}/{} 个频率的相干性低于 {}，已排除</translation>
    </message>
    <message>
        <source>use more periods or a larger amplitude there</source>
        <translation>请在该处增加周期数或增大幅值</translation>
    </message>
    <message>
        <source>use a higher end frequency, or a lower start frequency</source>
        <translation>请提高终止频率或降低起始频率</translation>
    </message>
    <message>
        <source>allowed: {} dB; use more periods, and calibrate the sensor gains and the stray field first</source>
        <translation>允许 {} dB；请增加周期数，并先标定传感器增益和杂散磁场</translation>
    </message>
    <message>
        <source>no gain margin: between {} and {} dB, uncertainty at best {}</source>
        <translation>无幅值裕度：在 {} 与 {} dB 之间，不确定度最好为 {}</translation>
    </message>
    <message>
        <source>no gain margin: phase crossover in a range without valid frequencies</source>
        <translation>无幅值裕度：相位穿越处没有有效频率</translation>
    </message>
    <message>
        <source>no gain margin: no phase crossover among the valid frequencies</source>
        <translation>无幅值裕度：有效频率内没有相位穿越</translation>
    </message>
    <message>
        <source>allowed: {} deg; use more periods, and calibrate the sensor gains and the stray field first</source>
        <translation>允许 {} deg；请增加周期数，并先标定传感器增益和杂散磁场</translation>
    </message>
    <message>
        <source>no phase margin: between {} and {} deg, uncertainty at best {}</source>
        <translation>无相位裕度：在 {} 与 {} deg 之间，不确定度最好为 {}</translation>
    </message>
    <message>
        <source>no phase margin: gain crossover in a range without valid frequencies</source>
        <translation>无相位裕度：增益穿越处没有有效频率</translation>
    </message>
    <message>
        <source>no phase margin: no gain crossover among the valid frequencies</source>
        <translation>无相位裕度：有效频率内没有增益穿越</translation>
    </message>
    <message>
        <source>rows missing near {} Hz: the periods are not consistent</source>
        <translation>{} Hz 附近缺少数据：各周期不一致</translation>
    </message>
    <message>
        <source>check its points for an angle error or a resonance</source>
        <translation>请检查各点是否有角度误差或共振</translation>
    </message>
    <message>
        <source>the measured response does not match a rotor</source>
        <translation>测得的响应与转子不符</translation>
    </message>
    <message>
        <source>measure more frequencies, or with a larger amplitude</source>
        <translation>请测量更多频率，或增大幅值</translation>
    </message>
    <message>
        <source>check that the reference generator was running</source>
        <translation>请检查参考信号发生器是否运行</translation>
    </message>
    <message>
        <source>an excited row contains a value that is not a number</source>
        <translation>激励数据中含有非数字的值</translation>
    </message>
    <message>
        <source>{} periods are too few to estimate the scatter</source>
        <translation>{} 个周期太少，无法估计离散</translation>
    </message>
    <message>
        <source>the excited rows are not complete periods of three signals</source>
        <translation>激励数据不是三个信号的完整周期</translation>
    </message>
    <message>
        <source>check the delay (delay.samples), or use a slower loop</source>
        <translation>请检查时延 (delay.samples)，或采用较慢的回路</translation>
    </message>
    <message>
        <source>one more sample of delay makes this loop unstable: delay margin {} ms</source>
        <translation>时延增加一个采样会使该回路不稳定：时延裕度 {} ms</translation>
    </message>
    <message>
        <source>design &apos;{}&apos; exists already</source>
        <translation>设计 &apos;{}&apos; 已存在</translation>
    </message>
    <message>
        <source>use a lower crossover, or method lead or phase-margin</source>
        <translation>请降低穿越频率，或用 lead 或 phase-margin 方法</translation>
    </message>
    <message>
        <source>this rule gives little damping: use method recommended, bandwidth or phase-margin</source>
        <translation>此规则阻尼很小：请用 recommended、bandwidth 或 phase-margin 方法</translation>
    </message>
    <message>
        <source>use a lower bandwidth</source>
        <translation>请降低带宽</translation>
    </message>
    <message>
        <source>this rule needs a motor with damping: c/J = 0 in its model</source>
        <translation>此规则需要有阻尼的电机：其模型中 c/J = 0</translation>
    </message>
    <message>
        <source>omit the filter (filter_s null): the device uses the difference of two samples; if the noise is too large, reduce K_D</source>
        <translation>请去掉滤波 (filter_s null)：设备使用两个采样值之差；若噪声过大，请减小 K_D</translation>
    </message>
    <message>
        <source>the device&apos;s control law has no derivative filter; these gains have a filter of {} s</source>
        <translation>设备的控制律没有微分滤波；这些增益带有 {} s 的滤波</translation>
    </message>
    <message>
        <source>PI (lag) with the requested crossover</source>
        <translation>PI（滞后），穿越频率按要求</translation>
    </message>
    <message>
        <source>PD (lead) with the requested phase margin</source>
        <translation>PD（超前），相位裕度按要求</translation>
    </message>
    <message>
        <source>same with time-weighted error: penalises long-lasting errors</source>
        <translation>同上，误差按时间加权：惩罚持续误差</translation>
    </message>
    <message>
        <source>linear-quadratic regulator, weights for the requested frequency</source>
        <translation>线性二次型调节器，按所需频率加权</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, P: half of the ultimate gain</source>
        <translation>Ziegler–Nichols P：临界增益的一半</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PI, from ultimate gain and period</source>
        <translation>Ziegler–Nichols PI，由临界增益和周期得到</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PID, from ultimate gain and period; fast starting point</source>
        <translation>Ziegler–Nichols PID，由临界增益和周期得到；响应较快的起点</translation>
    </message>
    <message>
        <source>lambda tuning: closed loop as a double lag of the requested bandwidth</source>
        <translation>Lambda 整定：闭环为所需带宽的二重惯性环节</translation>
    </message>
    <message>
        <source>use a lower crossover against resonance or noise: method bandwidth, or lead</source>
        <translation>若有共振或噪声，请降低穿越频率：bandwidth 或 lead 方法</translation>
    </message>
    <message>
        <source>the device&apos;s control law has no {} filter</source>
        <translation>设备的控制律没有 {} 滤波器</translation>
    </message>
    <message>
        <source>the system buffers no more than {} ms of this stream; data may be lost: raise its limit (sysctl net.core.rmem_max={}), use fewer signals or a lower rate, or connect by tcp:</source>
        <translation>系统对此数据流的缓冲不超过 {} ms；可能丢失数据：请提高限值 (sysctl net.core.rmem_max={})，减少信号或降低速率，或用 tcp: 连接</translation>
    </message>
    <message>
        <source>still stopped: {}</source>
        <translation>仍处于停止：{}</translation>
    </message>
    <message>
        <source>release state unknown</source>
        <translation>停止是否已解除未知</translation>
    </message>
    <message>
        <source>no valid motor among the samples</source>
        <translation>抽样中没有有效的电机</translation>
    </message>
    <message>
        <source>a relay experiment needs a level, a period and an oscillation larger than its hysteresis</source>
        <translation>继电实验需要幅度、周期以及大于迟滞的振荡</translation>
    </message>
    <message>
        <source>this process does not oscillate under proportional control: no ultimate gain</source>
        <translation>该过程在比例控制下不振荡：没有临界增益</translation>
    </message>
    <message>
        <source>weight every state that does not decay by itself</source>
        <translation>请对每个不会自行衰减的状态加权</translation>
    </message>
    <message>
        <source>allow a larger Ms, or reduce the computing delay</source>
        <translation>请允许更大的 Ms，或减小计算时延</translation>
    </message>
    <message>
        <source>use a slower target, or reduce the computing delay</source>
        <translation>请采用较慢的目标，或减小计算时延</translation>
    </message>
    <message>
        <source>invalid design targets: they must be positive, Ms above 1</source>
        <translation>设计目标无效：必须为正，Ms 大于 1</translation>
    </message>
    <message>
        <source>invalid filter: {} is out of range</source>
        <translation>滤波器无效：{} 超出范围</translation>
    </message>
    <message>
        <source>this sampled system does not correspond to a continuous one</source>
        <translation>此采样系统不对应任何连续系统</translation>
    </message>
    <message>
        <source>Use a shorter distance, or set {} on the device. Nothing was armed.</source>
        <translation>请缩短行程，或在设备上设置 {}。未使能。</translation>
    </message>
    <message>
        <source>Use a longer move. Check the gains and that the axis is free.</source>
        <translation>请延长运动时间。检查增益，并确认轴未受阻。</translation>
    </message>
    <message>
        <source>Use a longer move. Check the gains and that the rotor is free.</source>
        <translation>请延长运动时间。检查增益，并确认转子未受阻。</translation>
    </message>
    <message>
        <source>Check that no other program uses the device, then move again.</source>
        <translation>请确认没有其他程序使用该设备，然后再次运动。</translation>
    </message>
    <message>
        <source>Check the rotor position and that no other program uses the device, then move again.</source>
        <translation>请检查转子位置并确认没有其他程序使用该设备，然后再次运动。</translation>
    </message>
    <message>
        <source>check the position of the actuator, then start again; newer firmware tolerates a lost answer</source>
        <translation>请检查执行器的位置，然后重新启动；较新固件可容忍应答丢失</translation>
    </message>
    <message>
        <source>{}; ended, because its start was not confirmed</source>
        <translation>{}；因启动未得到确认，已结束</translation>
    </message>
    <message>
        <source>the device sent more than requested</source>
        <translation>设备发送的数据多于请求</translation>
    </message>
    <message>
        <source>{}: the kernel driver &apos;{}&apos; cannot be detached: {}</source>
        <translation>{}：无法分离内核驱动 &apos;{}&apos;：{}</translation>
    </message>
    <message>
        <source>to use it as device, connect to {}: the driver is detached until you disconnect</source>
        <translation>若要作为设备使用，请连接 {}：断开之前驱动程序被分离</translation>
    </message>
    <message>
        <source>use another port, or start the computer without &apos;console=&apos; for this one</source>
        <translation>请使用其他端口，或启动计算机时不对此端口设置 &apos;console=&apos;</translation>
    </message>
    <message>
        <source>the computer was too busy or in standby: connect again, with fewer signals or a lower rate</source>
        <translation>计算机过忙或处于休眠：请减少信号或降低速率后重新连接</translation>
    </message>
    <message>
        <source>{} MB from the device were not processed in time</source>
        <translation>设备的 {} MB 数据未能及时处理</translation>
    </message>
    <message>
        <source>identify this device and use its model for tuning</source>
        <translation>请辨识此设备，并用其模型整定</translation>
    </message>
    <message>
        <source>Rejected: this loop is unstable</source>
        <translation>拒绝：该回路不稳定</translation>
    </message>
    <message>
        <source>Doubtful: read the warnings before applying</source>
        <translation>存疑：应用前请阅读警告</translation>
    </message>
    <message>
        <source>Stable under the stated assumptions:</source>
        <translation>在所述假设下稳定：</translation>
    </message>
    <message>
        <source>{} rows lost: disk too slow</source>
        <translation>丢失 {} 行：磁盘太慢</translation>
    </message>
    <message>
        <source>with dead time the gain of this loop must fall below 1 at high frequency</source>
        <translation>有死区时间时，该回路在高频处的增益必须降到 1 以下</translation>
    </message>
    <message>
        <source>change the gain slightly</source>
        <translation>请略微改变增益</translation>
    </message>
    <message>
        <source>the Nyquist curve passes through -1: the loop is at the stability limit</source>
        <translation>Nyquist 曲线经过 -1：回路处于稳定界限</translation>
    </message>
    <message>
        <source>the device reports neither its firmware nor the identification in its description: it is unknown whether they match</source>
        <translation>设备既不报告固件，也不提供其描述中的标识：无法确定二者是否匹配</translation>
    </message>
    <message>
        <source>at most {} can be read; write parts with --from and --to</source>
        <translation>至多可读 {}；请用 --from 和 --to 分部分写入</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: incomplete</source>
        <translation>无法写入 &apos;{}&apos;：不完整</translation>
    </message>
    <message>
        <source>end the other connection, then connect again; an inactive connection ends after a few seconds</source>
        <translation>请结束另一连接后重新连接；不活动的连接会在几秒后结束</translation>
    </message>
    <message>
        <source>{}: another program is connected to this device</source>
        <translation>{}：其他程序已连接此设备</translation>
    </message>
    <message>
        <source>use the description of this firmware, or update the firmware completely</source>
        <translation>请使用此固件的描述，或完整更新固件</translation>
    </message>
    <message>
        <source>writing is blocked: the description does not match the firmware of the device</source>
        <translation>禁止写入：描述与设备固件不符</translation>
    </message>
    <message>
        <source>firmware &apos;{}&apos; does not match the description of &apos;{}&apos;: writing is blocked; use the description of this firmware, or update the firmware completely</source>
        <translation>固件 &apos;{}&apos; 与描述 &apos;{}&apos; 不符：禁止写入；请使用此固件的描述，或完整更新固件</translation>
    </message>
    <message>
        <source>its length does not match {} rows</source>
        <translation>长度与 {} 行不符</translation>
    </message>
    <message>
        <source>its time channel or link is invalid</source>
        <translation>时间通道或链接无效</translation>
    </message>
    <message>
        <source>its row length does not match its channels</source>
        <translation>行长度与通道不符</translation>
    </message>
    <message>
        <source>not a valid signal name</source>
        <translation>不是有效的信号名</translation>
    </message>
    <message>
        <source>only MDF4 files of Halbench can be read; export CSV in that program</source>
        <translation>只能读取 Halbench 的 MDF4 文件；请在该程序中导出 CSV</translation>
    </message>
    <message>
        <source>the file is from another program</source>
        <translation>文件来自其他程序</translation>
    </message>
    <message>
        <source>writing was interrupted; write it again</source>
        <translation>写入被中断；请重新写入</translation>
    </message>
    <message>
        <source>the file must begin with &quot;MDF&quot;</source>
        <translation>文件必须以 &quot;MDF&quot; 开头</translation>
    </message>
    <message>
        <source>not an MDF file</source>
        <translation>不是 MDF 文件</translation>
    </message>
    <message>
        <source>unexpected links</source>
        <translation>链接不符</translation>
    </message>
    <message>
        <source>invalid length {}</source>
        <translation>长度 {} 无效</translation>
    </message>
    <message>
        <source>unexpected block type</source>
        <translation>块类型不符</translation>
    </message>
    <message>
        <source>it is outside the file</source>
        <translation>位于文件之外</translation>
    </message>
    <message>
        <source>{}: block {} at byte {}: {}</source>
        <translation>{}：块 {}（字节 {}）：{}</translation>
    </message>
    <message>
        <source>the file is damaged or from another program; export CSV there</source>
        <translation>文件损坏或来自其他程序；请在该程序中导出 CSV</translation>
    </message>
    <message>
        <source>reduce the overlap, or use a part of the recording</source>
        <translation>请减小重叠，或使用记录的一部分</translation>
    </message>
    <message>
        <source>{} segments of {} lines exceed the size of a spectrogram</source>
        <translation>{} 段（每段 {} 条谱线）超过频谱图的大小</translation>
    </message>
    <message>
        <source>use a shorter segment, or a part of the recording with constant rate</source>
        <translation>请使用较短的分段，或记录中速率恒定的部分</translation>
    </message>
    <message>
        <source>the rate is not constant: {} rows from {} s on take {} s, average {} s</source>
        <translation>速率不恒定：{} 行（自 {} s 起）用时 {} s，平均 {} s</translation>
    </message>
    <message>
        <source>a segment of {} s is too long: the longest part without gap or missing value has {} rows, {} s</source>
        <translation>{} s 的分段过长：无间断和缺失值的最长部分为 {} 行，{} s</translation>
    </message>
    <message>
        <source>record for longer, or at a rate without losses</source>
        <translation>请延长记录时间，或用不丢失数据的速率</translation>
    </message>
    <message>
        <source>fewer than {} consecutive rows without gap or missing value</source>
        <translation>无间断和缺失值的连续行少于 {} 行</translation>
    </message>
    <message>
        <source>use a recording with more rows</source>
        <translation>请使用行数更多的记录</translation>
    </message>
    <message>
        <source>{} rows are too few for a sample rate</source>
        <translation>{} 行不足以确定采样率</translation>
    </message>
    <message>
        <source>a spectrum needs a constant sample rate; resample the signal first</source>
        <translation>频谱需要恒定的采样率；请先对信号重采样</translation>
    </message>
    <message>
        <source>uneven sampling: {} s before row {}, usually {} s</source>
        <translation>采样不均匀：{} s（第 {} 行之前），通常为 {} s</translation>
    </message>
    <message>
        <source>sort the rows by time</source>
        <translation>请按时间对各行排序</translation>
    </message>
    <message>
        <source>time does not increase from row {} to row {}</source>
        <translation>第 {} 行到第 {} 行时间没有递增</translation>
    </message>
    <message>
        <source>this device does not report whether it stopped: use the stop switch at the actuator</source>
        <translation>此设备不报告是否已停止：请使用执行器上的停止开关</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; was skipped: {}</source>
        <translation>参数 &apos;{}&apos; 已跳过：{}</translation>
    </message>
    <message>
        <source>the parameters of &apos;{}&apos; are read-only: the active page of the device cannot be written</source>
        <translation>&apos;{}&apos; 的参数只读：设备的活动页不可写</translation>
    </message>
    <message>
        <source>{}: addresses accept no option except a2l</source>
        <translation>{}: 地址除 a2l 外不接受选项</translation>
    </message>
    <message>
        <source>the description &apos;{}&apos; has {} bytes</source>
        <translation>描述 &apos;{}&apos; 有 {} 字节</translation>
    </message>
    <message>
        <source>give the A2L file for the device&apos;s firmware</source>
        <translation>请给出设备固件对应的 A2L 文件</translation>
    </message>
    <message>
        <source>give the port of the device first, e.g. tcp:HOST:PORT</source>
        <translation>请先给出设备端口，例如 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>device &apos;{}&apos; has a built-in description and does not use a file</source>
        <translation>设备 &apos;{}&apos; 有内置描述，不使用文件</translation>
    </message>
    <message>
        <source>recommended for this motor</source>
        <translation>推荐用于此电机</translation>
    </message>
    <message>
        <source>check the rows again, then restore</source>
        <translation>请重新检查各行，然后恢复</translation>
    </message>
    <message>
        <source>the device changed before writing started</source>
        <translation>写入开始前设备已改变</translation>
    </message>
    <message>
        <source>plug it in to any port</source>
        <translation>插入任意端口即可</translation>
    </message>
    <message>
        <source>signals and parameters may differ: disconnect, then connect again</source>
        <translation>信号和参数可能不同：请断开后重新连接</translation>
    </message>
    <message>
        <source>{} reconnected with other firmware: {} instead of {}</source>
        <translation>{} 重新连接后固件不同：{}，原为 {}</translation>
    </message>
    <message>
        <source>plug in the previous device, or disconnect and connect this one</source>
        <translation>请插入原设备，或断开后连接此设备</translation>
    </message>
    <message>
        <source>check for another program or a loose connector, then connect again</source>
        <translation>请检查是否有其他程序或插头松动，然后重新连接</translation>
    </message>
    <message>
        <source>{} reconnected and was lost again {} times in a row</source>
        <translation>{} 连续 {} 次重新连接后又断开</translation>
    </message>
    <message>
        <source>{} plateaus were not steady at their end and were excluded</source>
        <translation>{} 个平台结束时未达稳态，已排除</translation>
    </message>
    <message>
        <source>one plateau was not steady at its end and was excluded</source>
        <translation>1 个平台结束时未达稳态，已排除</translation>
    </message>
    <message>
        <source>{} plateaus were too slow to distinguish friction from creep and were excluded</source>
        <translation>{} 个平台太慢，无法区分摩擦与爬行，已排除</translation>
    </message>
    <message>
        <source>one plateau was too slow to distinguish friction from creep and was excluded</source>
        <translation>1 个平台太慢，无法区分摩擦与爬行，已排除</translation>
    </message>
    <message>
        <source>one plateau came to rest and was excluded</source>
        <translation>1 个平台停止，已排除</translation>
    </message>
    <message>
        <source>&apos;{}&apos; occurs twice</source>
        <translation>&apos;{}&apos; 重复</translation>
    </message>
    <message>
        <source>&apos;device.{}&apos; is not allowed here</source>
        <translation>此处不允许 &apos;device.{}&apos;</translation>
    </message>
    <message>
        <source>nothing was written; correct this line or use another file</source>
        <translation>未写入任何内容；请更正此行或使用其他文件</translation>
    </message>
    <message>
        <source>the value read back differs</source>
        <translation>回读值不同</translation>
    </message>
    <message>
        <source>nothing was written; disarm first</source>
        <translation>未写入任何内容；请先解除使能</translation>
    </message>
    <message>
        <source>a configuration cannot be restored while the actuator is armed</source>
        <translation>执行器已使能时不能恢复配置</translation>
    </message>
    <message>
        <source>nothing was written; leave it out</source>
        <translation>未写入任何内容；请去掉该项</translation>
    </message>
    <message>
        <source>nothing was written; choose one of its rows</source>
        <translation>未写入任何内容；请从其中的行选择</translation>
    </message>
    <message>
        <source>check each row: a value may have another meaning in this firmware</source>
        <translation>请检查每一行：数值在此固件中可能有不同含义</translation>
    </message>
    <message>
        <source>its calibration was measured on that device and is excluded unless selected</source>
        <translation>其标定在该设备上测得，除非选择，否则不包含</translation>
    </message>
    <message>
        <source>record again with the description of this firmware</source>
        <translation>请用此固件的描述重新记录</translation>
    </message>
    <message>
        <source>check whether the device was reset; the recording has a gap here</source>
        <translation>请检查设备是否复位；记录在此处有间断</translation>
    </message>
    <message>
        <source>the device clock restarted: the time before this row is unknown</source>
        <translation>设备时钟重新启动：此行之前的时间未知</translation>
    </message>
    <message>
        <source>use a lower start frequency, more periods or a larger amplitude</source>
        <translation>请降低起始频率、增加周期数或增大幅值</translation>
    </message>
    <message>
        <source>damping undetermined: between zero and {} % of the torque at the lowest frequency</source>
        <translation>阻尼无法确定：在零与最低频率处转矩的 {} % 之间</translation>
    </message>
    <message>
        <source>parameter {} of the device may still be {} instead of {} ms, as before arming: {}</source>
        <translation>设备参数 {} 可能仍为 {} 而非 {} ms，与使能前相同：{}</translation>
    </message>
    <message>
        <source>not available on this device</source>
        <translation>此设备没有该项</translation>
    </message>
    <message>
        <source>unit &apos;{}&apos; in the file, &apos;{}&apos; on the device</source>
        <translation>文件中的单位为 &apos;{}&apos;，设备上为 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>this value is a command or read-only on the device</source>
        <translation>此值在设备上为命令或只读</translation>
    </message>
    <message>
        <source>nothing was written; use a file for this model</source>
        <translation>未写入任何内容；请使用此型号的文件</translation>
    </message>
    <message>
        <source>the configuration is for a device of model &apos;{}&apos;, this device is of model &apos;{}&apos;</source>
        <translation>配置用于型号 &apos;{}&apos; 的设备，此设备的型号为 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the firmware of &apos;{}&apos; changed from &apos;{}&apos; to &apos;{}&apos;; the description was read again</source>
        <translation>&apos;{}&apos; 的固件由 &apos;{}&apos; 变为 &apos;{}&apos;；已重新读取描述</translation>
    </message>
    <message>
        <source>connect again; if the error remains, update the firmware</source>
        <translation>请重新连接；若错误仍存在，请更新固件</translation>
    </message>
    <message>
        <source>the device&apos;s description ends after {} bytes</source>
        <translation>设备描述在 {} 字节后中断</translation>
    </message>
    <message>
        <source>check device and address; on a serial line also baud rate and framing</source>
        <translation>请检查设备和地址；串口还需检查波特率和帧格式</translation>
    </message>
    <message>
        <source>check address and port: another program uses this port</source>
        <translation>请检查地址和端口：其他程序正在使用此端口</translation>
    </message>
    <message>
        <source>{}: {}; not the expected protocol</source>
        <translation>{}：{}；不是预期的协议</translation>
    </message>
    <message>
        <source>{} % of the rows of the recording are missing</source>
        <translation>记录缺失 {} % 的行</translation>
    </message>
    <message>
        <source>give the share of messages, e.g. 0.01 for 1 %</source>
        <translation>请给出消息的比例，例如 0.01 表示 1 %</translation>
    </message>
    <message>
        <source>connect again and compare the parameters before arming</source>
        <translation>请重新连接，并在使能前比较参数</translation>
    </message>
    <message>
        <source>{}; restoring the previous values is not confirmed: {}</source>
        <translation>{}；恢复原值未得到确认：{}</translation>
    </message>
    <message>
        <source>check the cause of the stop, then try again</source>
        <translation>请检查停止的原因，然后重试</translation>
    </message>
    <message>
        <source>interrupted by a stop; not executed</source>
        <translation>被停止中断；未执行</translation>
    </message>
    <message>
        <source>{}: the device accepts no more commands</source>
        <translation>{}：设备不再接受命令</translation>
    </message>
    <message>
        <source>{}: the device halted its endpoint</source>
        <translation>{}：设备已停止其端点</translation>
    </message>
    <message>
        <source>use {} or {}</source>
        <translation>请使用 {} 或 {}</translation>
    </message>
    <message>
        <source>plug it in; &apos;halbench devices&apos; lists the addresses</source>
        <translation>请插入；&apos;halbench devices&apos; 列出地址</translation>
    </message>
    <message>
        <source>plug in the correct device, or use {}</source>
        <translation>请插入正确的设备，或使用 {}</translation>
    </message>
    <message>
        <source>{}: the connected device has the serial number &apos;{}&apos;</source>
        <translation>{}：已连接设备的序列号为 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>close it there; if it is not open, remove {}</source>
        <translation>请在那里关闭；若未打开，请删除 {}</translation>
    </message>
    <message>
        <source>remove the cause, then release the stop again</source>
        <translation>请排除原因，然后再次解除停止</translation>
    </message>
    <message>
        <source>interrupted by a stop</source>
        <translation>被停止中断</translation>
    </message>
    <message>
        <source>a stop was sent before the device answered</source>
        <translation>在设备应答之前发送了停止</translation>
    </message>
    <message>
        <source>{}: connection attempt ended</source>
        <translation>{}：连接尝试已结束</translation>
    </message>
    <message>
        <source>{} sends data ({} bytes), but not in this protocol</source>
        <translation>{} 在发送数据（{} 字节），但不是此协议</translation>
    </message>
    <message>
        <source>serial:{}: the device accepts no more commands</source>
        <translation>serial:{}：设备不再接受命令</translation>
    </message>
    <message>
        <source>use 115200 or a rate supported by the adapter</source>
        <translation>请使用 115200 或适配器支持的波特率</translation>
    </message>
    <message>
        <source>{} does not support {} baud</source>
        <translation>{} 不支持 {} 波特</translation>
    </message>
    <message>
        <source>give a serial port; &apos;halbench devices&apos; lists them</source>
        <translation>请指定串口；&apos;halbench devices&apos; 列出串口</translation>
    </message>
    <message>
        <source>check the cable and that the device is on</source>
        <translation>请检查电缆和设备电源</translation>
    </message>
    <message>
        <source>plug the device in; &apos;halbench devices&apos; lists the addresses</source>
        <translation>请插入设备；&apos;halbench devices&apos; 列出地址</translation>
    </message>
    <message>
        <source>{} not found</source>
        <translation>未找到 {}</translation>
    </message>
    <message>
        <source>close that program (ModemManager releases a new port after some seconds)</source>
        <translation>请关闭该程序（ModemManager 会在几秒后释放新端口）</translation>
    </message>
    <message>
        <source>disconnect there first</source>
        <translation>请先在那里断开</translation>
    </message>
    <message>
        <source>install the rules printed by &apos;halbench devices --udev-rules&apos;, then plug the device in again</source>
        <translation>请安装 &apos;halbench devices --udev-rules&apos; 打印的规则，然后重新插入设备</translation>
    </message>
    <message>
        <source>use two different bytes</source>
        <translation>请使用两个不同的字节</translation>
    </message>
    <message>
        <source>give one byte in hexadecimal digits, e.g. 9A</source>
        <translation>请给出一个十六进制字节，例如 9A</translation>
    </message>
    <message>
        <source>old gains restored</source>
        <translation>已恢复旧增益</translation>
    </message>
    <message>
        <source>cancelled by the user</source>
        <translation>用户已取消</translation>
    </message>
    <message>
        <source>{} % of the motors within the model&apos;s uncertainty are unstable with this loop</source>
        <translation>模型不确定度范围内有 {} % 的电机在此回路下不稳定</translation>
    </message>
    <message>
        <source>the model has no covariance: robustness assumes an exactly known motor</source>
        <translation>模型没有协方差：稳健性按精确已知的电机计算</translation>
    </message>
    <message>
        <source>the motor&apos;s damping exceeds the target: K_D is zero</source>
        <translation>电机阻尼超过目标：K_D 为零</translation>
    </message>
    <message>
        <source>use method designed for these gains</source>
        <translation>如需这些增益，请用 designed 方法</translation>
    </message>
    <message>
        <source>the targets of the source (zeta 0.06 at 15 rad/s) give {} A/rad and {} A/(rad s) on this motor, not the printed 10 and 0.1</source>
        <translation>文献的目标（zeta 0.06，15 rad/s）在此电机上得到 {} A/rad 和 {} A/(rad s)，而不是刊载的 10 和 0.1</translation>
    </message>
    <message>
        <source>Damaged values from the device or the link; no result.</source>
        <translation>设备或链路传来损坏的值；没有结果。</translation>
    </message>
    <message>
        <source>axis {} is linear, but the reference is an angle</source>
        <translation>轴 {} 为直线轴，但参考为角度</translation>
    </message>
    <message>
        <source>axis {} is rotary, but the reference is a length</source>
        <translation>轴 {} 为旋转轴，但参考为长度</translation>
    </message>
    <message>
        <source>{} does not fit the other keys: a length with an angle</source>
        <translation>{} 与其他键不符：长度与角度混用</translation>
    </message>
    <message>
        <source>the device has no axis zero and cannot find it</source>
        <translation>设备没有轴零点，也无法找到</translation>
    </message>
    <message>
        <source>waiting for standstill</source>
        <translation>等待静止</translation>
    </message>
    <message>
        <source>the device followed another reference than commanded, deviation {}</source>
        <translation>设备跟随的参考信号与指令不同，偏差 {}</translation>
    </message>
    <message>
        <source>the device did not start its reference</source>
        <translation>设备未启动参考信号</translation>
    </message>
    <message>
        <source>the response contains a value that is not a number</source>
        <translation>响应中含有非数字的值</translation>
    </message>
    <message>
        <source>the response has too few samples to evaluate</source>
        <translation>响应的样本太少，无法评估</translation>
    </message>
    <message>
        <source>the covariance contains &apos;{}&apos;, for which the model has no value</source>
        <translation>协方差含有 &apos;{}&apos;，但模型中没有该值</translation>
    </message>
    <message>
        <source>{} is missing in the model; it determines the loop</source>
        <translation>模型中缺少 {}；它决定回路特性</translation>
    </message>
    <message>
        <source>use currents well above the breakaway current for several seconds each</source>
        <translation>请使用明显高于起动电流的电流，各保持数秒</translation>
    </message>
    <message>
        <source>only the torque constant is used</source>
        <translation>仅使用转矩常数</translation>
    </message>
    <message>
        <source>the damping gives another inertia ({} standard errors): the added part changed the friction</source>
        <translation>由阻尼得到不同的惯量（{} 倍标准误差）：附加部件改变了摩擦</translation>
    </message>
    <message>
        <source>both runs must determine c/J, K_f/J and phi/J with covariance, without given constants</source>
        <translation>两次运行都须在无给定常数的情况下确定 c/J、K_f/J 和 phi/J 及其协方差</translation>
    </message>
    <message>
        <source>add transients (run-up and coast-down), or another given constant</source>
        <translation>请增加过渡过程（升速和自由减速）或另一个给定常数</translation>
    </message>
    <message>
        <source>data and given constants do not determine all four constants</source>
        <translation>数据和给定常数无法确定全部四个常数</translation>
    </message>
    <message>
        <source>angle and current determine only ratios of the constants</source>
        <translation>角度和电流只能确定各常数的比值</translation>
    </message>
    <message>
        <source>omitting one plateau shifts the steady line by {} standard errors</source>
        <translation>去掉一个平台会使稳态直线移动 {} 倍标准误差</translation>
    </message>
    <message>
        <source>friction may depend on speed; check the residuals</source>
        <translation>摩擦可能与转速有关；请检查残差</translation>
    </message>
    <message>
        <source>friction may depend on speed; use only the relevant speed range</source>
        <translation>摩擦可能与转速有关；请只用相关的转速范围</translation>
    </message>
    <message>
        <source>steady speed is not linear in the current (lack of fit, p = {})</source>
        <translation>稳态转速与电流不成线性（失拟，p = {}）</translation>
    </message>
    <message>
        <source>check the plateaus of low weight; repeat the sweep</source>
        <translation>请检查权重低的平台；重复测量序列</translation>
    </message>
    <message>
        <source>torque changes with speed more than current lag explains: commutation angle or stray-field compensation is wrong</source>
        <translation>转矩随转速的变化超过电流滞后的影响：换相角或杂散磁场补偿有误</translation>
    </message>
    <message>
        <source>friction may depend on speed: the intervals do not include this error; use higher currents only</source>
        <translation>摩擦可能与转速有关：区间不含此误差；请只用更大的电流</translation>
    </message>
    <message>
        <source>model inadequate: the residual of one segment is {} times larger than usual</source>
        <translation>模型不充分：某一段的残差是通常的 {} 倍</translation>
    </message>
    <message>
        <source>use a longer time at each current</source>
        <translation>请延长每个电流的时间</translation>
    </message>
    <message>
        <source>{} plateaus came to rest and were excluded</source>
        <translation>{} 个平台停止，已排除</translation>
    </message>
    <message>
        <source>the curvature of the motion is too small to determine c/J</source>
        <translation>运动的弯曲太小，无法确定 c/J</translation>
    </message>
    <message>
        <source>the recording has {} rows per second, less than 100</source>
        <translation>记录每秒 {} 行，少于 100</translation>
    </message>
    <message>
        <source>required columns: time_s, position_rad and current_command_A; present: {}</source>
        <translation>所需列：time_s、position_rad 和 current_command_A；现有：{}</translation>
    </message>
    <message>
        <source>signals position or current_command missing in the recording</source>
        <translation>记录中缺少信号 position 或 current_command</translation>
    </message>
    <message>
        <source>record at least several seconds of motion</source>
        <translation>请记录至少数秒的运动</translation>
    </message>
    <message>
        <source>the recording has too few rows</source>
        <translation>记录的行数太少</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a constant of the motor</source>
        <translation>&apos;{}&apos; 不是电机常数</translation>
    </message>
    <message>
        <source>Nothing was armed. Use a shorter run or less current, or let the motor cool.</source>
        <translation>未使能。请缩短运行时间或减小电流，或让电机冷却。</translation>
    </message>
    <message>
        <source>expected coil temperature {} degC, limit {} degC</source>
        <translation>预计线圈温度 {} degC，限值 {} degC</translation>
    </message>
    <message>
        <source>cooling the coils: {} degC</source>
        <translation>线圈冷却中：{} degC</translation>
    </message>
    <message>
        <source>Cool the motor, then try again.</source>
        <translation>请冷却电机后重试。</translation>
    </message>
    <message>
        <source>coil temperature {} degC, does not fall below {} degC</source>
        <translation>线圈温度 {} degC，未降到 {} degC 以下</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a trigger</source>
        <translation>&apos;{}&apos; 不是触发条件</translation>
    </message>
    <message>
        <source>Damaged values from the device or the link; nothing was saved.</source>
        <translation>设备或链路传来损坏的值；未保存任何内容。</translation>
    </message>
    <message>
        <source>the device captured other signals than requested</source>
        <translation>设备捕获的信号与请求不符</translation>
    </message>
    <message>
        <source>waiting for the trigger</source>
        <translation>等待触发</translation>
    </message>
    <message>
        <source>use a higher current</source>
        <translation>请使用更大的电流</translation>
    </message>
    <message>
        <source>the rotor broke away in too few ramps</source>
        <translation>转子起动的斜坡次数太少</translation>
    </message>
    <message>
        <source>current ramp from rest</source>
        <translation>从静止开始的电流斜坡</translation>
    </message>
    <message>
        <source>d-axis current at standstill</source>
        <translation>静止时的 d 轴电流</translation>
    </message>
    <message>
        <source>turning to the next angle</source>
        <translation>转到下一角度</translation>
    </message>
    <message>
        <source>no calibration selected</source>
        <translation>未选择标定</translation>
    </message>
    <message>
        <source>turning fast (angle error)</source>
        <translation>快速转动（角度误差）</translation>
    </message>
    <message>
        <source>the rotor did not turn fast and long enough to measure the residual angle error of the ellipse</source>
        <translation>转子转动不够快、不够久，无法测量椭圆的残余角度误差</translation>
    </message>
    <message>
        <source>use the ellipse without the map</source>
        <translation>请仅用椭圆，不用修正表</translation>
    </message>
    <message>
        <source>the residual angle error of the ellipse, {} degrees rms, is too uncertain ({} degrees from speed ripple and scatter)</source>
        <translation>椭圆的残余角度误差 {} 度（均方根）不确定度过大（转速波动和离散引起 {} 度）</translation>
    </message>
    <message>
        <source>use a rotation current above the breakaway current</source>
        <translation>请使用大于起动电流的转动电流</translation>
    </message>
    <message>
        <source>turning slowly (Hall sensors)</source>
        <translation>慢速转动（霍尔传感器）</translation>
    </message>
    <message>
        <source>check for saturated sensors or a loose magnet</source>
        <translation>请检查传感器是否饱和或磁体是否松动</translation>
    </message>
    <message>
        <source>distance of the readings from the ellipse: {} % of the amplitude</source>
        <translation>读数与椭圆的距离：幅值的 {} %</translation>
    </message>
    <message>
        <source>Old values restored. Identify the motor again, or use lower gains.</source>
        <translation>已恢复旧值。请重新辨识电机，或使用较低的增益。</translation>
    </message>
    <message>
        <source>{}: {} {}, limit of the prediction {} {}</source>
        <translation>{}：{} {}，预测限值 {} {}</translation>
    </message>
    <message>
        <source>no prediction available for a {}</source>
        <translation>没有可用于 {} 的预测</translation>
    </message>
    <message>
        <source>Old values restored. Check the device limits.</source>
        <translation>已恢复旧值。请检查设备限值。</translation>
    </message>
    <message>
        <source>use a ramp for large moves, or a slower loop</source>
        <translation>大行程请使用斜坡，或采用较慢的回路</translation>
    </message>
    <message>
        <source>steps above {} deg reach the current limit of {} A; with limit and friction a step of {} deg overshoots by {} %</source>
        <translation>超过 {} deg 的阶跃会达到 {} A 的电流限值；考虑限值和摩擦时，{} deg 的阶跃超调 {} %</translation>
    </message>
    <message>
        <source>error of the stray coefficient {} %, this gain requires less than {} %</source>
        <translation>杂散系数的误差 {} %，此增益要求小于 {} %</translation>
    </message>
    <message>
        <source>this gain requires a stray coefficient known to better than {} %; its error is unknown</source>
        <translation>此增益要求杂散系数的误差小于 {} %；其误差未知</translation>
    </message>
    <message>
        <source>the stray field of the coils is not compensated and couples the current into the angle: with this gain the loop can alternate every sample</source>
        <translation>线圈的杂散磁场未补偿，电流耦合到角度中：此增益下回路可能逐个采样交替振荡</translation>
    </message>
    <message>
        <source>only the integral action removes the standstill error, slowly; the micro-step assist or a larger K_P narrows the band</source>
        <translation>只有积分作用能缓慢消除静态误差；微步辅助或更大的 K_P 可缩小该范围</translation>
    </message>
    <message>
        <source>usual minimum: 30 deg and factor 2</source>
        <translation>通常的最小值：30 deg 和系数 2</translation>
    </message>
    <message>
        <source>small margins: phase {} deg, gain factor {}</source>
        <translation>裕度小：相位 {} deg，增益系数 {}</translation>
    </message>
    <message>
        <source>a PI loop has little damping on this motor; add derivative action: method recommended</source>
        <translation>PI 回路在此电机上阻尼很小；请加入微分作用：recommended 方法</translation>
    </message>
    <message>
        <source>the loop is nearly undamped (zeta = {} at {} rad/s): damping is by friction only</source>
        <translation>回路几乎无阻尼（zeta = {}，{} rad/s）：仅靠摩擦阻尼</translation>
    </message>
    <message>
        <source>the rotor makes at best small steps; large steps end in a limit cycle</source>
        <translation>转子最多只能作小阶跃；大阶跃导致极限环</translation>
    </message>
    <message>
        <source>only friction and the current limit bound the motion; stable above {} times these gains: increase them, or use method recommended</source>
        <translation>仅摩擦和电流限值限制运动；高于这些增益的 {} 倍时稳定：请增大增益，或使用 recommended 方法</translation>
    </message>
    <message>
        <source>only friction and the current limit bound the motion; stable below {} times these gains: reduce K_P, or use method recommended</source>
        <translation>仅摩擦和电流限值限制运动；低于这些增益的 {} 倍时稳定：请减小 K_P，或使用 recommended 方法</translation>
    </message>
    <message>
        <source>only friction and the current limit bound the motion, and no common factor on these gains gives stability: change their ratio or the filters, or use method recommended</source>
        <translation>仅摩擦和电流限值限制运动，且这些增益乘以任何公共系数都不稳定：请改变其比例或滤波器，或使用 recommended 方法</translation>
    </message>
    <message>
        <source>K_P = {}, K_I = {}, K_D = {} is not a valid position loop</source>
        <translation>K_P = {}、K_I = {}、K_D = {} 不是有效的位置环</translation>
    </message>
    <message>
        <source>no picture to save</source>
        <translation>没有可保存的图片</translation>
    </message>
    <message>
        <source>open it with the newer version, or install that version</source>
        <translation>请用新版本打开，或安装该版本</translation>
    </message>
    <message>
        <source>{}: is a &apos;{}&apos; of a newer version</source>
        <translation>{}：是更新版本的 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the file is not changed; open another project or correct this line</source>
        <translation>文件未改变；请打开其他项目或更正此行</translation>
    </message>
    <message>
        <source>check its findings, then identify again</source>
        <translation>请查看诊断，然后重新辨识</translation>
    </message>
    <message>
        <source>{}: this estimate was rejected</source>
        <translation>{}：此估计被拒绝</translation>
    </message>
    <message>
        <source>report this with the command line used</source>
        <translation>请连同所用的命令行报告此问题</translation>
    </message>
    <message>
        <source>a coil of {} mm width leaves no winding window within half a pitch of {} mm</source>
        <translation>{} mm 宽的线圈在 {} mm 的半节距内没有绕组窗口</translation>
    </message>
    <message>
        <source>The direction of the jump is unknown. Check the sensors or turn more slowly.</source>
        <translation>跳变方向未知。请检查传感器或放慢转速。</translation>
    </message>
    <message>
        <source>the device&apos;s description has {} bytes</source>
        <translation>设备描述有 {} 字节</translation>
    </message>
    <message>
        <source>the device has no built-in description</source>
        <translation>设备没有内置描述</translation>
    </message>
    <message>
        <source>{} stopped responding</source>
        <translation>{} 停止响应</translation>
    </message>
    <message>
        <source>make sure that no other program uses the device, then connect again</source>
        <translation>请确认没有其他程序使用该设备，然后重新连接</translation>
    </message>
    <message>
        <source>{} ended the session (watchdog timeout, or another program connected)</source>
        <translation>{} 结束了会话（看门狗超时，或其他程序已连接）</translation>
    </message>
    <message>
        <source>the device rejected {}: {}</source>
        <translation>设备拒绝 {}：{}</translation>
    </message>
    <message>
        <source>value of &apos;{}&apos; after writing: {} {} instead of {}</source>
        <translation>&apos;{}&apos; 写入后的值：{} {}，应为 {}</translation>
    </message>
    <message>
        <source>this device cannot change a set at once: values change one by one</source>
        <translation>此设备不能一次更改整组：各值逐个改变</translation>
    </message>
    <message>
        <source>the old values are kept; use values within the device limits</source>
        <translation>保留旧值；请使用设备限值内的值</translation>
    </message>
    <message>
        <source>the value of &apos;{}&apos; read back differs from the one sent</source>
        <translation>&apos;{}&apos; 的回读值与发送值不同</translation>
    </message>
    <message>
        <source>the device or another program ended the stream; connect again</source>
        <translation>设备或其他程序结束了数据流；请重新连接</translation>
    </message>
    <message>
        <source>{} stopped sending samples</source>
        <translation>{} 停止发送样本</translation>
    </message>
    <message>
        <source>, the device clock is fast by {} +- {} ppm</source>
        <translation>，设备时钟快 {} ± {} ppm</translation>
    </message>
    <message>
        <source>the device does not release its stop: {}</source>
        <translation>设备未解除停止：{}</translation>
    </message>
    <message>
        <source>use the stop switch at the actuator and check the device</source>
        <translation>请使用执行器上的停止开关并检查设备</translation>
    </message>
    <message>
        <source>the device does not {}</source>
        <translation>设备未执行 {}</translation>
    </message>
    <message>
        <source>remove the cause, then release the stop</source>
        <translation>请排除原因，然后解除停止</translation>
    </message>
    <message>
        <source>use the manufacturer&apos;s program to arm it</source>
        <translation>请用制造商的程序使能</translation>
    </message>
    <message>
        <source>this device has no &apos;{}&apos; and cannot be armed by this program</source>
        <translation>此设备没有 &apos;{}&apos;，本程序无法使能</translation>
    </message>
    <message>
        <source>the description was not cached: {}</source>
        <translation>描述未缓存：{}</translation>
    </message>
    <message>
        <source>description read from the device, {} bytes</source>
        <translation>已从设备读取描述，{} 字节</translation>
    </message>
    <message>
        <source>stream only signals of the same event together</source>
        <translation>请只将同一事件的信号放在一个数据流中</translation>
    </message>
    <message>
        <source>the device samples &apos;{}&apos; ({}) at another event than &apos;{}&apos; ({})</source>
        <translation>设备对 &apos;{}&apos;（{}）与 &apos;{}&apos;（{}）的采样事件不同</translation>
    </message>
    <message>
        <source>the nearest possible rate: {} Hz</source>
        <translation>最接近的可用速率：{} Hz</translation>
    </message>
    <message>
        <source>the nearest possible rates: {} Hz and {} Hz</source>
        <translation>最接近的可用速率：{} Hz 和 {} Hz</translation>
    </message>
    <message>
        <source>the old values are kept; check the limits of the device</source>
        <translation>保留旧值；请检查设备的限值</translation>
    </message>
    <message>
        <source>the values read back differ from those sent</source>
        <translation>回读的值与发送的值不同</translation>
    </message>
    <message>
        <source>check the state of the device; the old values are kept</source>
        <translation>请检查设备状态；保留旧值</translation>
    </message>
    <message>
        <source>the device did not accept the new parameter set</source>
        <translation>设备未接受新的参数组</translation>
    </message>
    <message>
        <source>check that the control loop is running; the old values are kept</source>
        <translation>请检查控制回路是否运行；保留旧值</translation>
    </message>
    <message>
        <source>the device does not release its inactive parameter page</source>
        <translation>设备未释放其非活动参数页</translation>
    </message>
    <message>
        <source>only pages 0 and 1 are supported; update the firmware</source>
        <translation>仅支持 0 页和 1 页；请更新固件</translation>
    </message>
    <message>
        <source>the device uses page {} of a segment of {} bytes</source>
        <translation>设备使用 {} 页，段长 {} 字节</translation>
    </message>
    <message>
        <source>invalid sampling resolution ({})</source>
        <translation>采样分辨率无效（{}）</translation>
    </message>
    <message>
        <source>the answer to GET_ID announces {} bytes and contains {}</source>
        <translation>GET_ID 的应答声明 {} 字节，实际 {} 字节</translation>
    </message>
    <message>
        <source>the device does not use a supported protocol</source>
        <translation>设备未使用受支持的协议</translation>
    </message>
    <message>
        <source>the device announces packets of {} and {} bytes, at least 8 are required</source>
        <translation>设备声明的数据包为 {} 和 {} 字节，至少需要 8 字节</translation>
    </message>
    <message>
        <source>only byte granularity is supported</source>
        <translation>仅支持字节粒度</translation>
    </message>
    <message>
        <source>the device counts addresses in words, not bytes</source>
        <translation>设备按字而非字节计数地址</translation>
    </message>
    <message>
        <source>the answer to {} has {} bytes ({}), {} are required</source>
        <translation>对 {} 的应答有 {} 字节（{}），需要 {} 字节</translation>
    </message>
    <message>
        <source>the device rejects the command</source>
        <translation>设备拒绝该命令</translation>
    </message>
    <message>
        <source>free disk space or make the folder writable</source>
        <translation>请释放磁盘空间或使文件夹可写</translation>
    </message>
    <message>
        <source>use fewer signals</source>
        <translation>请减少信号</translation>
    </message>
    <message>
        <source>{} signals do not fit into one sample of this device</source>
        <translation>{} 个信号无法放入此设备的一次采样</translation>
    </message>
    <message>
        <source>signal {} has {} bytes; the device samples values of up to {} bytes in steps of {}</source>
        <translation>信号 {} 有 {} 字节；设备对至多 {} 字节、步长 {} 的值采样</translation>
    </message>
    <message>
        <source>this device has no capture function</source>
        <translation>此设备没有捕获功能</translation>
    </message>
    <message>
        <source>&apos;{}&apos; (byte {} of the description): {}</source>
        <translation>&apos;{}&apos;（描述的第 {} 字节）：{}</translation>
    </message>
    <message>
        <source>its type &apos;{}&apos; is unknown</source>
        <translation>其类型 &apos;{}&apos; 未知</translation>
    </message>
    <message>
        <source>found /end {} where /end {} is expected</source>
        <translation>出现 /end {}，应为 /end {}</translation>
    </message>
    <message>
        <source>description of the device, byte {}: {}</source>
        <translation>设备描述，第 {} 字节：{}</translation>
    </message>
    <message>
        <source>{} bytes exceed the allowed {}</source>
        <translation>{} 字节超过允许的 {}</translation>
    </message>
    <message>
        <source>the device closed the connection (possibly taken over by another program)</source>
        <translation>设备关闭了连接（可能被其他程序接管）</translation>
    </message>
    <message>
        <source>the device accepts no more commands</source>
        <translation>设备不再接受命令</translation>
    </message>
    <message>
        <source>check that the device is on and not used by another program, then connect again</source>
        <translation>请检查设备已开启且未被其他程序占用，然后重新连接</translation>
    </message>
    <message>
        <source>check that the device is on and the address is correct</source>
        <translation>请检查设备已开启且地址正确</translation>
    </message>
    <message>
        <source>the other side does not use this protocol</source>
        <translation>对方不使用此协议</translation>
    </message>
    <message>
        <source>message length {} bytes, allowed are 1 to {}</source>
        <translation>消息长度 {} 字节，允许 1 至 {}</translation>
    </message>
    <message>
        <source>give each key only once</source>
        <translation>每个键只给一次</translation>
    </message>
    <message>
        <source>use a shorter time</source>
        <translation>请使用更短的时间</translation>
    </message>
    <message>
        <source>use a rate that divides {} Hz</source>
        <translation>请使用能整除 {} Hz 的速率</translation>
    </message>
    <message>
        <source>the recording of {} Hz cannot be replayed at {} Hz</source>
        <translation>{} Hz 的记录无法以 {} Hz 回放</translation>
    </message>
    <message>
        <source>connect a real or simulated device</source>
        <translation>请连接真实设备或仿真设备</translation>
    </message>
    <message>
        <source>this is a recording: it cannot be changed, armed or stopped</source>
        <translation>这是记录：不能更改、使能或停止</translation>
    </message>
    <message>
        <source>wait until it is finished, or use another name</source>
        <translation>请等待其完成，或使用其他名称</translation>
    </message>
    <message>
        <source>remove the .meta.json file to read the data without it</source>
        <translation>删除 .meta.json 文件后读取数据</translation>
    </message>
    <message>
        <source>{}: byte {}: {}</source>
        <translation>{}：第 {} 字节：{}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no complete row</source>
        <translation>&apos;{}&apos; 没有完整的行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} bytes</source>
        <translation>&apos;{}&apos; 有 {} 个字节</translation>
    </message>
    <message>
        <source>write numbers like -1.5e-3, with a decimal point</source>
        <translation>请将数字写成 -1.5e-3，使用小数点</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; occurs twice</source>
        <translation>&apos;{}&apos; 列重复</translation>
    </message>
    <message>
        <source>its range is {} s to {} s</source>
        <translation>其范围为 {} s 至 {} s</translation>
    </message>
    <message>
        <source>it has no rows</source>
        <translation>没有任何行</translation>
    </message>
    <message>
        <source>available: {}</source>
        <translation>可用：{}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has a format that cannot be written</source>
        <translation>&apos;{}&apos; 的格式无法写入</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has a format that cannot be read</source>
        <translation>&apos;{}&apos; 的格式无法读取</translation>
    </message>
    <message>
        <source>use a longer excitation, a wider band or fewer lines</source>
        <translation>请延长激励、加宽频带或减少谱线</translation>
    </message>
    <message>
        <source>{} to {} Hz cannot contain {} lines {} Hz apart</source>
        <translation>{} 至 {} Hz 容不下 {} 条间隔 {} Hz 的谱线</translation>
    </message>
    <message>
        <source>an algebraic loop: one of the two systems needs a delay</source>
        <translation>代数环：两个系统之一需要时延</translation>
    </message>
    <message>
        <source>add the filter or actuator of the real system</source>
        <translation>请加入实际系统的滤波器或执行器</translation>
    </message>
    <message>
        <source>{} rad/s is outside the frequency range of the system</source>
        <translation>{} rad/s 超出系统的频率范围</translation>
    </message>
    <message>
        <source>the records do not separate torque, friction and damping</source>
        <translation>这些记录无法区分转矩、摩擦和阻尼</translation>
    </message>
    <message>
        <source>record run-ups or coast-downs</source>
        <translation>请记录升速或自由减速</translation>
    </message>
    <message>
        <source>record at a higher rate or for a longer time</source>
        <translation>请提高速率或延长记录时间</translation>
    </message>
    <message>
        <source>the fit depends on single points</source>
        <translation>拟合取决于个别点</translation>
    </message>
    <message>
        <source>check the recording for faults</source>
        <translation>请检查记录中的错误</translation>
    </message>
    <message>
        <source>use a longer plateau time</source>
        <translation>请延长平台时间</translation>
    </message>
    <message>
        <source>sort the rows and remove duplicates</source>
        <translation>请对各行排序并去除重复</translation>
    </message>
    <message>
        <source>the recording contains a value that is not a number</source>
        <translation>记录中含有非数字的值</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs besides steady motion</source>
        <translation>除匀速运动外，请记录升速和自由减速</translation>
    </message>
    <message>
        <source>the segments have no curvature: damping undetermined</source>
        <translation>各段没有弯曲：阻尼无法确定</translation>
    </message>
    <message>
        <source>the damping cannot be determined from the motion</source>
        <translation>无法由该运动确定阻尼</translation>
    </message>
    <message>
        <source>remove the damaged rows</source>
        <translation>请删除损坏的行</translation>
    </message>
    <message>
        <source>record at a higher rate</source>
        <translation>请提高记录速率</translation>
    </message>
    <message>
        <source>a segment of the motion has too few samples</source>
        <translation>某个运动段的样本太少</translation>
    </message>
    <message>
        <source>the recording has no motion under constant current</source>
        <translation>记录中没有恒定电流下的运动</translation>
    </message>
    <message>
        <source>use more different currents, speeds or directions</source>
        <translation>请使用更多不同的电流、转速或方向</translation>
    </message>
    <message>
        <source>the points do not separate the coefficients</source>
        <translation>这些点无法区分各系数</translation>
    </message>
    <message>
        <source>{} usable points cannot determine {} coefficients</source>
        <translation>{} 个可用点无法确定 {} 个系数</translation>
    </message>
    <message>
        <source>check the recording for gaps or faults</source>
        <translation>请检查记录中的间断或错误</translation>
    </message>
    <message>
        <source>the speed does not increase with the current</source>
        <translation>转速没有随电流增大</translation>
    </message>
    <message>
        <source>use at least three currents in one direction, or four in both</source>
        <translation>请至少在一个方向用三个电流，或在两个方向用四个</translation>
    </message>
    <message>
        <source>too few plateaus to estimate the scatter</source>
        <translation>平台太少，无法估计离散</translation>
    </message>
    <message>
        <source>exclude plateaus that come to rest from the fit</source>
        <translation>请从拟合中排除停止的平台</translation>
    </message>
    <message>
        <source>at one plateau the rotor stands still or turns against the current</source>
        <translation>某个平台上转子静止或逆电流方向转动</translation>
    </message>
    <message>
        <source>parts of the recording do not cover a full turn</source>
        <translation>部分记录没有覆盖整圈</translation>
    </message>
    <message>
        <source>turn the rotor by several full turns</source>
        <translation>请将转子转动数整圈</translation>
    </message>
    <message>
        <source>use a higher current, from rest</source>
        <translation>请从静止加到更大的电流</translation>
    </message>
    <message>
        <source>the rotor did not break away during the ramp</source>
        <translation>转子在斜坡过程中没有起动</translation>
    </message>
    <message>
        <source>record from the start of the ramp</source>
        <translation>请从斜坡开始处记录</translation>
    </message>
    <message>
        <source>step it with both signs</source>
        <translation>请以正负两种符号阶跃</translation>
    </message>
    <message>
        <source>use a higher speed before the coast-down, or add a second current</source>
        <translation>请提高自由减速前的转速，或增加第二个电流</translation>
    </message>
    <message>
        <source>all usable motion is at one current (coast-downs missing or too short): torque and friction cannot be separated</source>
        <translation>所有可用运动都在同一电流下（自由减速缺失或太短）：无法区分转矩与摩擦</translation>
    </message>
    <message>
        <source>repeat some currents</source>
        <translation>请重复部分电流</translation>
    </message>
    <message>
        <source>no repeated points to check the model</source>
        <translation>没有用于检验模型的重复点</translation>
    </message>
    <message>
        <source>fix a larger known inertia to the rotor, about equal to the rotor&apos;s own; the first run must be without it</source>
        <translation>请在转子上固定更大的已知惯量，约与转子自身惯量相当；第一次运行时不得装上</translation>
    </message>
    <message>
        <source>the added inertia is not significant compared with the errors of both runs</source>
        <translation>附加惯量相对于两次运行的误差不显著</translation>
    </message>
    <message>
        <source>the covariance of the model is not valid</source>
        <translation>模型的协方差无效</translation>
    </message>
    <message>
        <source>phi/J = {}, c/J = {}, K_f/phi = {} is not a valid motor: torque per ampere must be positive, damping and friction not negative</source>
        <translation>phi/J = {}、c/J = {}、K_f/phi = {} 不是有效的电机：每安培转矩必须为正，阻尼和摩擦不得为负</translation>
    </message>
    <message>
        <source>use the parallel or the standard form</source>
        <translation>请使用并联或标准形式</translation>
    </message>
    <message>
        <source>use the parallel form</source>
        <translation>请使用并联形式</translation>
    </message>
    <message>
        <source>without proportional gain the time-constant forms do not exist</source>
        <translation>没有比例增益时不存在时间常数形式</translation>
    </message>
    <message>
        <source>without integral action the integral time is infinite</source>
        <translation>无积分作用时积分时间为无穷大</translation>
    </message>
    <message>
        <source>an integral time of zero means an infinite integral gain</source>
        <translation>积分时间为零意味着积分增益无穷大</translation>
    </message>
    <message>
        <source>the step response of this unstable loop overflows</source>
        <translation>该不稳定回路的阶跃响应溢出</translation>
    </message>
    <message>
        <source>printed numbers read per degree; large steps end in a limit cycle</source>
        <translation>按度解释的刊载数值；大阶跃导致极限环</translation>
    </message>
    <message>
        <source>zeta = 0.06 at 15 rad/s, as intended by the source</source>
        <translation>zeta = 0.06（15 rad/s），即文献的本意</translation>
    </message>
    <message>
        <source>stiffest loop with the requested phase margin</source>
        <translation>满足所需相位裕度的最高刚度回路</translation>
    </message>
    <message>
        <source>recommended shape with the requested closed-loop bandwidth</source>
        <translation>推荐形状，闭环带宽按要求</translation>
    </message>
    <message>
        <source>PI with the requested dominant pole pair, as far as the motor&apos;s damping allows</source>
        <translation>具有所需主导极点对的 PI，受电机阻尼限制</translation>
    </message>
    <message>
        <source>use 30 to 60 deg, or omit the crossover</source>
        <translation>请取 30 至 60 deg，或不指定穿越频率</translation>
    </message>
    <message>
        <source>zeta = {} at {} rad/s cannot be reached with a PI position loop on this motor: zeta &lt;= c/(2 J omega) = {}</source>
        <translation>此电机的 PI 位置环无法达到 zeta = {}（{} rad/s）：zeta &lt;= c/(2 J omega) = {}</translation>
    </message>
    <message>
        <source>the step height is zero</source>
        <translation>阶跃高度为零</translation>
    </message>
    <message>
        <source>the step response contains a value that is not finite</source>
        <translation>阶跃响应中含有非有限值</translation>
    </message>
    <message>
        <source>the values of a model depend on each other: identify again with --given, e.g. &apos;halbench identify FILE.csv --given J=5.5e-4 --out&apos;</source>
        <translation>模型的各值相互关联：请用 --given 重新辨识，例如 &apos;halbench identify FILE.csv --given J=5.5e-4 --out&apos;</translation>
    </message>
    <message>
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: missing, {} is assumed</source>
        <translation>&apos;{}&apos; 列（&apos;{}&apos; 中）的单位缺失，假定为 {}</translation>
    </message>
    <message>
        <source>correct the unit, or remove the .meta.json file to read the data without it</source>
        <translation>请更正单位，或删除 .meta.json 文件后读取数据</translation>
    </message>
    <message>
        <source>name the column with its quantity, e.g. {}, or give the unit with halbench import --unit</source>
        <translation>请按物理量命名该列，例如 {}，或用 halbench import --unit 指定单位</translation>
    </message>
    <message>
        <source>deg is an angle unit; write degrees Celsius as degC</source>
        <translation>deg 是角度单位；摄氏度请写为 degC</translation>
    </message>
    <message>
        <source>Use a longer recording, with the rotor moving and no channel clipped.</source>
        <translation>请使用更长的记录，使转子运动且没有通道饱和。</translation>
    </message>
    <message>
        <source>Move it through the whole workspace, tilt and spin.</source>
        <translation>请使其经过整个工作空间：倾斜并自转。</translation>
    </message>
    <message>
        <source>The common scale of all gains is not observable separately from the strength q: their mean is set to one. A known field is required; the orientation is not affected.</source>
        <translation>所有增益的公共比例无法与强度 q 区分：其平均值设为 1。需要已知磁场；不影响姿态。</translation>
    </message>
    <message>
        <source>A common rotation of all sensors is not observable: the mean rotation is set to zero. A known orientation is required to determine it.</source>
        <translation>所有传感器的共同旋转不可观测：平均旋转设为零。需要已知姿态才能确定。</translation>
    </message>
    <message>
        <source>An additive device has no tensor condition.</source>
        <translation>加性设备没有张量条件数。</translation>
    </message>
    <message>
        <source>The time does not increase in row {} of the table of poses.</source>
        <translation>位姿表第 {} 行的时间没有递增。</translation>
    </message>
    <message>
        <source>procedure {} is not available for this device; nothing was armed</source>
        <translation>流程 {} 不适用于此设备；未使能</translation>
    </message>
    <message>
        <source>use a procedure of this device: {}</source>
        <translation>请使用该设备的流程：{}</translation>
    </message>
    <message>
        <source>{}; choose one with --axis, in an experiment with the key &apos;axis&apos;</source>
        <translation>{}；请用 --axis 选择，在实验文件中用键 &apos;axis&apos;</translation>
    </message>
    <message>
        <source>{}; move one axis at a time</source>
        <translation>{}；请逐轴移动</translation>
    </message>
    <message>
        <source>write both ends around the value, or null</source>
        <translation>请写出包含该值的区间两端，或写 null</translation>
    </message>
    <message>
        <source>must be in ascending order, {} is more than {}</source>
        <translation>必须按升序，{} 大于 {}</translation>
    </message>
    <message>
        <source>must contain the value: {} is not in {} ... {}</source>
        <translation>必须包含该值：{} 不在 {} ... {} 之内</translation>
    </message>
    <message>
        <source>is {}, not possible for a motor</source>
        <translation>为 {}，电机不可能有此值</translation>
    </message>
    <message>
        <source>check the signs of current and angle in the recording, then identify again</source>
        <translation>请检查记录中电流与角度的符号，然后重新辨识</translation>
    </message>
    <message>
        <source>reaches from {} to {}: whether it is above zero is unknown</source>
        <translation>范围为 {} 至 {}：无法确定其值是否大于零</translation>
    </message>
    <message>
        <source>lower end of the interval of c/J: {} 1/s</source>
        <translation>c/J 区间的下端：{} 1/s</translation>
    </message>
    <message>
        <source>no finding gives the cause</source>
        <translation>诊断中没有给出原因</translation>
    </message>
    <message>
        <source>the model used for the assessment is doubtful: {}</source>
        <translation>评估所用的模型存疑：{}</translation>
    </message>
    <message>
        <source>check the findings of the model, then identify again</source>
        <translation>请查看模型的诊断，然后重新辨识</translation>
    </message>
    <message>
        <source>the calibration used for the assessment is doubtful: {}</source>
        <translation>评估所用的标定存疑：{}</translation>
    </message>
    <message>
        <source>check the findings of the calibration, then calibrate again</source>
        <translation>请查看标定的诊断，然后重新标定</translation>
    </message>
    <message>
        <source>the relay experiment for these gains is doubtful: {}</source>
        <translation>这些增益所依据的继电实验存疑：{}</translation>
    </message>
    <message>
        <source>check the findings of the experiment, then measure again</source>
        <translation>请查看实验的诊断，然后重新测量</translation>
    </message>
    <message>
        <source>this procedure needs a freely turning rotor; this device has axes with limited travel; nothing was armed</source>
        <translation>此流程需要可自由转动的转子；该设备的轴行程有限；未使能</translation>
    </message>
    <message>
        <source>use the command line; it selects the procedure for the device</source>
        <translation>请使用命令行；它会选择适合该设备的流程</translation>
    </message>
    <message>
        <source>{} % of the packets arrived out of order</source>
        <translation>{} % 的数据包顺序错乱</translation>
    </message>
    <message>
        <source>connect by tcp: instead of udp:; tcp keeps the order</source>
        <translation>请用 tcp: 代替 udp: 连接；tcp 保持顺序</translation>
    </message>
    <message>
        <source>{} % of the packets were lost, none was damaged</source>
        <translation>{} % 的数据包丢失，没有损坏</translation>
    </message>
    <message>
        <source>First line: time_s,alpha_deg,beta_deg,gamma_deg (or ..._rad); then numbers.</source>
        <translation>第一行：time_s,alpha_deg,beta_deg,gamma_deg（或 ..._rad）；其后为数字。</translation>
    </message>
    <message>
        <source>{}: value {} is not a number</source>
        <translation>{}：值 {} 不是数字</translation>
    </message>
    <message>
        <source>{}: the time does not increase</source>
        <translation>{}：时间没有递增</translation>
    </message>
    <message>
        <source>{}: no poses after the first line</source>
        <translation>{}：第一行之后没有位姿</translation>
    </message>
    <message>
        <source>friction may depend on speed, or torque is not proportional to the current</source>
        <translation>摩擦可能与转速有关，或转矩与电流不成正比</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: above {} A forward the torque per ampere is {} % of that below</source>
        <translation>转矩与指令电流不成正比：正向高于 {} A 时，每安培转矩为低于该值时的 {} %</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: above {} A in reverse the torque per ampere is {} % of that below</source>
        <translation>转矩与指令电流不成正比：反向高于 {} A 时，每安培转矩为低于该值时的 {} %</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: above {} A the torque per ampere is {} % of that below</source>
        <translation>转矩与指令电流不成正比：高于 {} A 时，每安培转矩为低于该值时的 {} %</translation>
    </message>
    <message>
        <source>measure the real current: the amplifier may saturate, have a dead zone or unequal gains; identify within its linear range</source>
        <translation>请测量实际电流：放大器可能饱和、有死区或增益不等；请在其线性范围内辨识</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: {} A less than commanded, compared with the coast-downs</source>
        <translation>转矩与指令电流不成正比：与自由减速相比，比指令少 {} A</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: torque per ampere differs by {} % between the directions</source>
        <translation>转矩与指令电流不成正比：两个方向的每安培转矩相差 {} %</translation>
    </message>
    <message>
        <source>torque per ampere changed by {} % during the recording</source>
        <translation>每安培的转矩在记录过程中变化了 {} %</translation>
    </message>
    <message>
        <source>let coils and magnets cool, check the supply, then record again</source>
        <translation>请让线圈和磁体冷却，检查电源，然后重新记录</translation>
    </message>
    <message>
        <source>friction changed by {} % during the recording</source>
        <translation>摩擦在记录过程中变化了 {} %</translation>
    </message>
    <message>
        <source>warm up the bearings, then record again</source>
        <translation>请先使轴承预热，然后重新记录</translation>
    </message>
    <message>
        <source>friction increases with the current: driving and braking differ by more than friction</source>
        <translation>摩擦随电流增大：驱动与制动之差超过摩擦</translation>
    </message>
    <message>
        <source>the torque may load the bearings: the uncertainty of the torque constant is larger than stated</source>
        <translation>转矩可能使轴承受载：转矩常数的不确定度大于所示值</translation>
    </message>
    <message>
        <source>torque is not proportional to the commanded current: not a straight line (lack of fit, p = {})</source>
        <translation>转矩与指令电流不成正比：不是直线（失拟，p = {}）</translation>
    </message>
    <message>
        <source>torque residuals of the segments up to {} % of the largest torque: more than run-to-run friction scatter</source>
        <translation>各段的转矩残差达最大转矩的 {} %：超过各次运行之间的摩擦离散</translation>
    </message>
    <message>
        <source>move the rotor</source>
        <translation>请转动转子</translation>
    </message>
    <message>
        <source>there are no rows</source>
        <translation>没有数据行</translation>
    </message>
    <message>
        <source>Cut the recording with halbench convert, or leave the reference columns out.</source>
        <translation>用 halbench convert 截取记录，或去掉参考列。</translation>
    </message>
    <message>
        <source>the known orientation at {} s is not a number</source>
        <translation>{} s 处的已知姿态不是数值</translation>
    </message>
    <message>
        <source>Convert it with halbench import --unit COLUMN=mT.</source>
        <translation>用 halbench import --unit COLUMN=mT 换算。</translation>
    </message>
    <message>
        <source>&apos;{}&apos; reads {} T: it is in another unit</source>
        <translation>'{}' 读数为 {} T：单位不对</translation>
    </message>
    <message>
        <source>there is no signal &apos;{}&apos;</source>
        <translation>没有信号 '{}'</translation>
    </message>
    <message>
        <source>Switch the coil off, or change its current in the record.</source>
        <translation>请关闭线圈，或在记录中改变其电流。</translation>
    </message>
    <message>
        <source>{} A flow through the coil all the time: its field is taken for offsets</source>
        <translation>线圈中始终有 {} A 电流：其磁场被当作偏置</translation>
    </message>
    <message>
        <source>Record with the coil&apos;s current switched between 0 and 1 A or more.</source>
        <translation>记录时请让线圈电流在 0 与 1 A 以上之间切换。</translation>
    </message>
    <message>
        <source>the coil&apos;s current changed by {} A only: its field keeps its value</source>
        <translation>线圈电流只变化了 {} A：其磁场保持原值</translation>
    </message>
    <message>
        <source>Record while the magnet warms up by 2 K or more.</source>
        <translation>请在磁体升温 2 K 以上时记录。</translation>
    </message>
    <message>
        <source>the temperature changed by {} K only: the drift of the field keeps its value</source>
        <translation>温度只变化了 {} K：磁场漂移保持原值</translation>
    </message>
    <message>
        <source>Check for a stuck channel, a changing stray field or iron near the rotor.</source>
        <translation>请检查是否有卡死的通道、变化的杂散磁场或转子附近的铁磁物。</translation>
    </message>
    <message>
        <source>the readings differ from the calibrated model by {} T rms</source>
        <translation>读数与标定模型相差 {} T(均方根)</translation>
    </message>
    <message>
        <source>Check the sensor; leave the channel out with channels.off and calibrate again.</source>
        <translation>请检查传感器；用 channels.off 排除该通道后重新标定。</translation>
    </message>
    <message>
        <source>{} comes out as {}: the channel is dead, stuck or wired wrongly</source>
        <translation>{} 得出 {}：该通道失效、卡死或接线错误</translation>
    </message>
    <message>
        <source>choose hall, stray or all</source>
        <translation>请选择 hall、stray 或 all</translation>
    </message>
    <message>
        <source>a device that only senses has no static friction to calibrate</source>
        <translation>只做测量的设备没有静摩擦可标定</translation>
    </message>
    <message>
        <source>the board followed another path than commanded, {} {} away</source>
        <translation>控制板所走路径与指令不同，偏差 {} {}</translation>
    </message>
    <message>
        <source>Move for longer, or leave the duration out.</source>
        <translation>请延长运动时间，或省略时长。</translation>
    </message>
    <message>
        <source>the {} takes {} s, the move ends after {} s</source>
        <translation>{} 需要 {} s，而运动在 {} s 后结束</translation>
    </message>
    <message>
        <source>Name no axis.</source>
        <translation>请不要指定轴。</translation>
    </message>
    <message>
        <source>a {} moves two axes</source>
        <translation>{} 会移动两个轴</translation>
    </message>
    <message>
        <source>Move one axis: a step, a trapezoid, an s-curve.</source>
        <translation>请移动单个轴：阶跃、梯形或 S 曲线。</translation>
    </message>
    <message>
        <source>this device follows no path of two axes</source>
        <translation>该设备不支持两轴路径</translation>
    </message>
    <message>
        <source>It has {}.</source>
        <translation>它有 {}。</translation>
    </message>
    <message>
        <source>the generator of axis {} has no {}</source>
        <translation>轴 {} 的发生器没有 {}</translation>
    </message>
    <message>
        <source>Leave base out.</source>
        <translation>请省略 base。</translation>
    </message>
    <message>
        <source>a {} has no constant motion</source>
        <translation>{} 没有匀速运动</translation>
    </message>
    <message>
        <source>Give the whole reference in angles or in lengths.</source>
        <translation>整个参考量请统一用角度或长度给出。</translation>
    </message>
    <message>
        <source>, whole numbers</source>
        <translation>，整数</translation>
    </message>
    <message>
        <source>phases of a multisine; 0: those of least peak</source>
        <translation>多正弦的相位；0：峰值最小的相位</translation>
    </message>
    <message>
        <source>largest jerk of an S-curve or path</source>
        <translation>S 曲线或路径的最大加加速度</translation>
    </message>
    <message>
        <source>the same of an axis that turns</source>
        <translation>同上，用于转动的轴</translation>
    </message>
    <message>
        <source>largest acceleration of a travel or path</source>
        <translation>行程或路径的最大加速度</translation>
    </message>
    <message>
        <source>constant motion added</source>
        <translation>附加的匀速运动</translation>
    </message>
    <message>
        <source>steps of a staircase, lines of a multisine</source>
        <translation>阶梯的级数，多正弦的谱线数</translation>
    </message>
    <message>
        <source>of a sine: 1/frequency; of a staircase: time of one step</source>
        <translation>正弦：1/频率；阶梯：单级时间</translation>
    </message>
    <message>
        <source>the last one of chirp and multisine</source>
        <translation>扫频与多正弦的终止频率</translation>
    </message>
    <message>
        <source>of a sine; the first one of chirp and multisine</source>
        <translation>正弦的频率；扫频与多正弦的起始频率</translation>
    </message>
    <message>
        <source>slope of a ramp, largest speed of a travel or path</source>
        <translation>斜坡的斜率，行程或路径的最大速度</translation>
    </message>
    <message>
        <source>the same in micrometres</source>
        <translation>同上，单位微米</translation>
    </message>
    <message>
        <source>the same in millimetres</source>
        <translation>同上，单位毫米</translation>
    </message>
    <message>
        <source>the same of an axis that moves along a line</source>
        <translation>同上，用于直线运动的轴</translation>
    </message>
    <message>
        <source>the same in microradians</source>
        <translation>同上，单位微弧度</translation>
    </message>
    <message>
        <source>the same in milliradians</source>
        <translation>同上，单位毫弧度</translation>
    </message>
    <message>
        <source>the same in radians</source>
        <translation>同上，单位弧度</translation>
    </message>
    <message>
        <source>height of the step or of one stair, amplitude of sine and chirp, rms of a multisine</source>
        <translation>阶跃或单级台阶的高度，正弦与扫频的幅值，多正弦的均方根值</translation>
    </message>
    <message>
        <source>The old values run again. The mass, the inertia or the force constant is not the one of the model: identify the axes anew.</source>
        <translation>已恢复旧值。质量、转动惯量或力常数与模型不符：请重新辨识各轴。</translation>
    </message>
    <message>
        <source>the motion took {} times the effort that the model needs for it, {} to {} are allowed</source>
        <translation>该运动所用的作用量为模型所需的 {} 倍，允许范围为 {} 至 {}</translation>
    </message>
    <message>
        <source>Give a distance.</source>
        <translation>请给出距离。</translation>
    </message>
    <message>
        <source>the distance of a travel is zero</source>
        <translation>行程的距离为零</translation>
    </message>
    <message>
        <source>Give a finite distance.</source>
        <translation>请给出有限的距离。</translation>
    </message>
    <message>
        <source>the distance of a travel is not a number</source>
        <translation>行程的距离不是数字</translation>
    </message>
    <message>
        <source>Give a limit above zero.</source>
        <translation>请给出大于零的限值。</translation>
    </message>
    <message>
        <source>the largest {} of a travel is {}</source>
        <translation>行程的最大 {} 为 {}</translation>
    </message>
    <message>
        <source>Give a finite limit.</source>
        <translation>请给出有限的限值。</translation>
    </message>
    <message>
        <source>the largest {} of a travel is not a number</source>
        <translation>行程的最大 {} 不是数字</translation>
    </message>
    <message>
        <source>Give at least one.</source>
        <translation>请至少给出一个。</translation>
    </message>
    <message>
        <source>a path of {} {}</source>
        <translation>含 {} {} 的路径</translation>
    </message>
    <message>
        <source>Give the {}.</source>
        <translation>请给出 {}。</translation>
    </message>
    <message>
        <source>the {} of a path is zero</source>
        <translation>路径的 {} 为零</translation>
    </message>
    <message>
        <source>Give a finite size.</source>
        <translation>请给出有限的尺寸。</translation>
    </message>
    <message>
        <source>the {} of a path is not a number</source>
        <translation>路径的 {} 不是数字</translation>
    </message>
    <message>
        <source>this procedure needs a freely turning rotor and is not available for this device; nothing was armed</source>
        <translation>此流程需要可自由转动的转子，不适用于此设备；未使能</translation>
    </message>
    <message>
        <source>A calibration needs positive deviations of readings, places and known orientations and at least one iteration.</source>
        <translation>标定需要读数、位置和已知姿态的正偏差，且至少迭代一次。</translation>
    </message>
    <message>
        <source>channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Derivative gain on the measured position</source>
        <translation>作用于测量位置的微分增益</translation>
    </message>
    <message>
        <source>look at the residuals over current, time and angle, and measure the current that flows</source>
        <translation>请查看残差随电流、时间和角度的变化，并测量实际流过的电流</translation>
    </message>
    <message>
        <source>K_f/phi is {} A from plateaus and {} A from all motion (p = {})</source>
        <translation>由平台得 K_f/phi 为 {} A，由全部运动得 {} A（p = {}）</translation>
    </message>
    <message>
        <source>Spherical motor, orientation sensing</source>
        <translation>球形电机，姿态测量</translation>
    </message>
    <message>
        <source>True temperature of the magnet, known to the simulation only</source>
        <translation>磁体的真实温度，仅仿真已知</translation>
    </message>
    <message>
        <source>True strength q of the field tensor, known to the simulation only</source>
        <translation>场张量的真实强度 q，仅仿真已知</translation>
    </message>
    <message>
        <source>True rate about stator Z, known to the simulation only</source>
        <translation>绕定子 Z 轴的真实角速度，仅仿真已知</translation>
    </message>
    <message>
        <source>True rate about stator Y, known to the simulation only</source>
        <translation>绕定子 Y 轴的真实角速度，仅仿真已知</translation>
    </message>
    <message>
        <source>True rate about stator X, known to the simulation only</source>
        <translation>绕定子 X 轴的真实角速度，仅仿真已知</translation>
    </message>
    <message>
        <source>True rotation about stator Z, first, known to the simulation only</source>
        <translation>绕定子 Z 轴的真实旋转，第一步，仅仿真已知</translation>
    </message>
    <message>
        <source>True rotation about stator Y, second, known to the simulation only</source>
        <translation>绕定子 Y 轴的真实旋转，第二步，仅仿真已知</translation>
    </message>
    <message>
        <source>True rotation about stator X, third, known to the simulation only</source>
        <translation>绕定子 X 轴的真实旋转，第三步，仅仿真已知</translation>
    </message>
    <message>
        <source>{}:1: not the columns of a motion</source>
        <translation>{}:1：不是运动的列</translation>
    </message>
    <message>
        <source>cannot read the poses &apos;{}&apos;</source>
        <translation>无法读取姿态文件“{}”</translation>
    </message>
    <message>
        <source>temperature coefficient</source>
        <translation>温度系数</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>rotor</source>
        <translation>转子</translation>
    </message>
    <message>
        <source>Silence of the host that ends its session</source>
        <translation>主机静默超过此时间即结束其会话</translation>
    </message>
    <message>
        <source>1, 2, 4 ...: channels to leave out, added</source>
        <translation>1、2、4……：要排除的通道，相加</translation>
    </message>
    <message>
        <source>Subtract the coil&apos;s field</source>
        <translation>减去线圈的磁场</translation>
    </message>
    <message>
        <source>Chi-square that is flagged; 1e-9 of healthy readings exceed it</source>
        <translation>给出标志的卡方值；正常读数超过它的概率为 1e-9</translation>
    </message>
    <message>
        <source>Share of the strength beyond which it is flagged</source>
        <translation>强度偏差超过此比例时给出标志</translation>
    </message>
    <message>
        <source>Temperature of the calibrated strength</source>
        <translation>标定强度对应的温度</translation>
    </message>
    <message>
        <source>Relative change of the field with temperature</source>
        <translation>磁场随温度的相对变化</translation>
    </message>
    <message>
        <source>Field of the stator coil at R, Theta, Phi of sensor 0, 1, 2</source>
        <translation>定子线圈在传感器 0、1、2 的 R、Theta、Phi 上的磁场</translation>
    </message>
    <message>
        <source>Offset of R, Theta, Phi of sensor 0, 1, 2</source>
        <translation>传感器 0、1、2 的 R、Theta、Phi 偏移</translation>
    </message>
    <message>
        <source>Cross-axis share R-Theta, R-Phi, Theta-Phi of sensor 0, 1, 2</source>
        <translation>传感器 0、1、2 的 R-Theta、R-Phi、Theta-Phi 交叉轴份额</translation>
    </message>
    <message>
        <source>Gain error of R, Theta, Phi of sensor 0, 1, 2</source>
        <translation>传感器 0、1、2 的 R、Theta、Phi 增益误差</translation>
    </message>
    <message>
        <source>Mounting error of sensor 0, 1, 2 about stator X, Y, Z</source>
        <translation>传感器 0、1、2 绕定子 X、Y、Z 轴的安装误差</translation>
    </message>
    <message>
        <source>Order of the placement angles</source>
        <translation>布置角的旋转顺序</translation>
    </message>
    <message>
        <source>Distance of the sensor from the centre</source>
        <translation>传感器到中心的距离</translation>
    </message>
    <message>
        <source>Placement of the sensor about stator Z</source>
        <translation>传感器绕定子 Z 轴的布置角</translation>
    </message>
    <message>
        <source>Placement of the sensor about stator Y</source>
        <translation>传感器绕定子 Y 轴的布置角</translation>
    </message>
    <message>
        <source>Placement of the sensor about stator X</source>
        <translation>传感器绕定子 X 轴的布置角</translation>
    </message>
    <message>
        <source>unrolled</source>
        <translation>无滚转</translation>
    </message>
    <message>
        <source>Rx Ry Rz</source>
        <translation>Rx Ry Rz</translation>
    </message>
    <message>
        <source>Rz Ry Rx</source>
        <translation>Rz Ry Rx</translation>
    </message>
    <message>
        <source>of this sample</source>
        <translation>来自本次采样</translation>
    </message>
    <message>
        <source>held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Whether these readings determined the orientation</source>
        <translation>这些读数是否确定了姿态</translation>
    </message>
    <message>
        <source>1 channel left out, 2 held, 4 residual, 8 strength, 16 untested, added</source>
        <translation>1 通道被排除，2 保持，4 残差，8 强度，16 未检验，相加</translation>
    </message>
    <message>
        <source>1, 2, 4 ...: channels that are not used, added</source>
        <translation>1、2、4……：未使用的通道，相加</translation>
    </message>
    <message>
        <source>Temperature at the magnet</source>
        <translation>磁体处的温度</translation>
    </message>
    <message>
        <source>Current of the stator coil</source>
        <translation>定子线圈的电流</translation>
    </message>
    <message>
        <source>Residual along Phi of sensor {}</source>
        <translation>传感器 {} 沿 Phi 的残差</translation>
    </message>
    <message>
        <source>Residual along Theta of sensor {}</source>
        <translation>传感器 {} 沿 Theta 的残差</translation>
    </message>
    <message>
        <source>Residual along R of sensor {}</source>
        <translation>传感器 {} 沿 R 的残差</translation>
    </message>
    <message>
        <source>Field along Phi of sensor {}</source>
        <translation>传感器 {} 沿 Phi 的磁场</translation>
    </message>
    <message>
        <source>Field along Theta of sensor {}</source>
        <translation>传感器 {} 沿 Theta 的磁场</translation>
    </message>
    <message>
        <source>Field along R of sensor {}</source>
        <translation>传感器 {} 沿 R 的磁场</translation>
    </message>
    <message>
        <source>Squared residuals over the deviation, 4 on average when all is well</source>
        <translation>残差平方与偏差平方之比，正常时平均为 4</translation>
    </message>
    <message>
        <source>The same by calibration and temperature</source>
        <translation>按标定和温度得到的同一量</translation>
    </message>
    <message>
        <source>Strength q of the field tensor at 50 mm</source>
        <translation>50 mm 处场张量的强度 q</translation>
    </message>
    <message>
        <source>Quaternion, Z</source>
        <translation>四元数，Z</translation>
    </message>
    <message>
        <source>Quaternion, Y</source>
        <translation>四元数，Y</translation>
    </message>
    <message>
        <source>Quaternion, X</source>
        <translation>四元数，X</translation>
    </message>
    <message>
        <source>Quaternion, real part</source>
        <translation>四元数，实部</translation>
    </message>
    <message>
        <source>Direction of the shaft, from X</source>
        <translation>转轴方向，从 X 轴量起</translation>
    </message>
    <message>
        <source>Direction of the shaft, from Z</source>
        <translation>转轴方向，从 Z 轴量起</translation>
    </message>
    <message>
        <source>Rotation about stator Z, first: the spin</source>
        <translation>绕定子 Z 轴的旋转，第一步：自转</translation>
    </message>
    <message>
        <source>Rotation about stator Y, second</source>
        <translation>绕定子 Y 轴的旋转，第二步</translation>
    </message>
    <message>
        <source>Rotation about stator X, third</source>
        <translation>绕定子 X 轴的旋转，第三步</translation>
    </message>
    <message>
        <source>identify again with larger currents</source>
        <translation>用更大的电流重新辨识</translation>
    </message>
    <message>
        <source>must be null or two finite numbers</source>
        <translation>必须为 null 或两个有限数</translation>
    </message>
    <message>
        <source>{}.ci95&quot; {}</source>
        <translation>{}.ci95&quot; {}</translation>
    </message>
    <message>
        <source>its axes are {}</source>
        <translation>其轴为 {}</translation>
    </message>
    <message>
        <source>choose a1 and a2 with 0 &lt; a2 &lt; a1 and 4 - 2 a1 + a2 &gt; 0</source>
        <translation>请选择满足 0 &lt; a2 &lt; a1 且 4 - 2 a1 + a2 &gt; 0 的 a1 和 a2</translation>
    </message>
    <message>
        <source>correct the coefficients of the section</source>
        <translation>请更正该环节的系数</translation>
    </message>
    <message>
        <source>leave some of them out</source>
        <translation>请去掉其中一些</translation>
    </message>
    <message>
        <source>Row {} of the table of poses is not finite.</source>
        <translation>姿态表第 {} 行不是有限值。</translation>
    </message>
    <message>
        <source>coil field {} of sensor {}</source>
        <translation>线圈磁场 {}，传感器 {}</translation>
    </message>
    <message>
        <source>place along {} of sensor {}</source>
        <translation>沿 {} 的位置，传感器 {}</translation>
    </message>
    <message>
        <source>frame about {} of sensor {}</source>
        <translation>绕 {} 的转角，传感器 {}</translation>
    </message>
    <message>
        <source>offset {} of sensor {}</source>
        <translation>零点偏移 {}，传感器 {}</translation>
    </message>
    <message>
        <source>skew {} of sensor {}</source>
        <translation>非正交 {}，传感器 {}</translation>
    </message>
    <message>
        <source>gain {} of sensor {}</source>
        <translation>增益 {}，传感器 {}</translation>
    </message>
    <message>
        <source>field strength {}</source>
        <translation>磁场强度 {}</translation>
    </message>
    <message>
        <source>The motion does not determine this value: {}.</source>
        <translation>运动不足以确定此值：{}。</translation>
    </message>
    <message>
        <source>Widen the region, reduce the distance or raise the range of the sensor.</source>
        <translation>请扩大区域、减小距离或提高传感器量程。</translation>
    </message>
    <message>
        <source>The constraints leave no pair of places for the sensors.</source>
        <translation>约束条件没有给传感器留下任何一对位置。</translation>
    </message>
    <message>
        <source>A placement needs sensors outside the rotor, a positive strength and noise, and at least one finalist.</source>
        <translation>布置需要传感器位于转子之外、强度和噪声为正，并至少一个入围方案。</translation>
    </message>
    <message>
        <source>The step of the placement lattice must divide 45 degrees and be at least 1 degree.</source>
        <translation>布置网格的步长必须整除 45 度且至少为 1 度。</translation>
    </message>
    <message>
        <source>harmonic ({},{})</source>
        <translation>球谐项 ({},{})</translation>
    </message>
    <message>
        <source>drift of {} with temperature</source>
        <translation>{} 随温度的漂移</translation>
    </message>
    <message>
        <source>Record orientations that differ more in tilt and spin, or keep it at its nominal value.</source>
        <translation>请记录倾斜和自转差异更大的姿态，或保持其标称值。</translation>
    </message>
    <message>
        <source>The calibration was stopped.</source>
        <translation>标定已停止。</translation>
    </message>
    <message>
        <source>The rotor moved by only {} degrees in the recording.</source>
        <translation>记录中转子只转动了 {} 度。</translation>
    </message>
    <message>
        <source>Nothing is selected to be calibrated.</source>
        <translation>没有选择要标定的内容。</translation>
    </message>
    <message>
        <source>Only {} samples have a known orientation; the calibration needs {}.</source>
        <translation>只有 {} 个采样的姿态已知；标定需要 {} 个。</translation>
    </message>
    <message>
        <source>m, rad, N or N*m; height of a step of the staircase, end of the ramp, distance</source>
        <translation>m、rad、N 或 N*m；阶梯的单级高度，斜坡的终点，行程</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>梯形</translation>
    </message>
    <message>
        <source>Pose and speed from the readings</source>
        <translation>由读数得到位姿和速度</translation>
    </message>
    <message>
        <source>Squared innovation of the tracking filter, 6 when all is well</source>
        <translation>跟踪滤波器的新息平方，正常为 6</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>最小二乘</translation>
    </message>
    <message>
        <source>tracking filter</source>
        <translation>跟踪滤波器</translation>
    </message>
    <message>
        <source>From the wrench to the currents</source>
        <translation>由力与力矩分配电流</translation>
    </message>
    <message>
        <source>set by set</source>
        <translation>逐对分配</translation>
    </message>
    <message>
        <source>heading, fundamental</source>
        <translation>考虑转角，基波</translation>
    </message>
    <message>
        <source>heading, all harmonics</source>
        <translation>考虑转角，所有谐波</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>chip</source>
        <translation>霍尔芯片</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>线圈</translation>
    </message>
    <message>
        <source>platen</source>
        <translation>动子</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Pose of the platen along {}</source>
        <translation>动子沿 {} 的位姿</translation>
    </message>
    <message>
        <source>Pose of the platen about the vertical</source>
        <translation>动子绕竖轴的转角</translation>
    </message>
    <message>
        <source>Speed of the platen along {}</source>
        <translation>动子沿 {} 的速度</translation>
    </message>
    <message>
        <source>Speed of the platen about the vertical</source>
        <translation>动子绕竖轴的转速</translation>
    </message>
    <message>
        <source>Reference, or effort in mode wrench, along {}</source>
        <translation>沿 {} 的参考值，力与力矩模式下为力</translation>
    </message>
    <message>
        <source>Reference, or effort in mode wrench, about the vertical</source>
        <translation>绕竖轴的参考值，力与力矩模式下为力矩</translation>
    </message>
    <message>
        <source>Force or torque of the currents along {}</source>
        <translation>电流沿 {} 产生的力或转矩</translation>
    </message>
    <message>
        <source>Force or torque of the currents about the vertical</source>
        <translation>电流绕竖轴产生的力或转矩</translation>
    </message>
    <message>
        <source>Current commanded into coil {}</source>
        <translation>线圈 {} 的给定电流</translation>
    </message>
    <message>
        <source>Field along x&apos; at chip {}</source>
        <translation>霍尔芯片 {} 处沿 x&apos; 的磁场</translation>
    </message>
    <message>
        <source>Field along y&apos; at chip {}</source>
        <translation>霍尔芯片 {} 处沿 y&apos; 的磁场</translation>
    </message>
    <message>
        <source>Vertical force of the coils, upward</source>
        <translation>线圈的竖直力，向上为正</translation>
    </message>
    <message>
        <source>Squared residuals of the readings over their deviation</source>
        <translation>读数残差平方与其偏差之比</translation>
    </message>
    <message>
        <source>Below 1: currents at their limit</source>
        <translation>小于 1：电流达到限值</translation>
    </message>
    <message>
        <source>Pitches from the first cell along {}</source>
        <translation>沿 {} 距起始单元的节距数</translation>
    </message>
    <message>
        <source>1, 2, 4: chips that are not used, added</source>
        <translation>1、2、4：未使用的霍尔芯片之和</translation>
    </message>
    <message>
        <source>The first cell was chosen</source>
        <translation>已选定起始单元</translation>
    </message>
    <message>
        <source>coil currents</source>
        <translation>线圈电流</translation>
    </message>
    <message>
        <source>wrench</source>
        <translation>力与力矩</translation>
    </message>
    <message>
        <source>pose jumped</source>
        <translation>位姿跳变</translation>
    </message>
    <message>
        <source>sensors determine no pose</source>
        <translation>传感器无法确定位姿</translation>
    </message>
    <message>
        <source>vertical force near the weight</source>
        <translation>竖直力接近重力</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Derivative gain on the measured speed</source>
        <translation>对实测速度的微分增益</translation>
    </message>
    <message>
        <source>Part of a step that the proportional gain sees</source>
        <translation>比例增益所作用的阶跃份额</translation>
    </message>
    <message>
        <source>Effort per acceleration of a profile</source>
        <translation>轨迹单位加速度所需的力或力矩</translation>
    </message>
    <message>
        <source>Moving mass</source>
        <translation>运动质量</translation>
    </message>
    <message>
        <source>Inertia about the vertical</source>
        <translation>绕竖轴的转动惯量</translation>
    </message>
    <message>
        <source>Centre of mass in platen axes</source>
        <translation>动子坐标系中的质心</translation>
    </message>
    <message>
        <source>Force per ampere; negative by the sign of the phases</source>
        <translation>每安培的力；因相位符号为负</translation>
    </message>
    <message>
        <source>Pitch of the magnet matrix</source>
        <translation>磁体阵列的节距</translation>
    </message>
    <message>
        <source>Width of a coil&apos;s winding</source>
        <translation>线圈绕组的宽度</translation>
    </message>
    <message>
        <source>Place of coils 5 and 6 along y&apos;</source>
        <translation>线圈 5 和 6 沿 y&apos; 的位置</translation>
    </message>
    <message>
        <source>Time constant of the speeds</source>
        <translation>速度估计的时间常数</translation>
    </message>
    <message>
        <source>Largest current of a coil</source>
        <translation>单个线圈的最大电流</translation>
    </message>
    <message>
        <source>Vertical force that trips</source>
        <translation>触发保护的竖直力</translation>
    </message>
    <message>
        <source>Largest excursion from where the mode began</source>
        <translation>自模式开始起的最大偏移</translation>
    </message>
    <message>
        <source>Largest rotation from where the mode began</source>
        <translation>自模式开始起的最大转角</translation>
    </message>
    <message>
        <source>Largest speed of rotation while armed</source>
        <translation>使能时的最大转速</translation>
    </message>
    <message>
        <source>Delay of the currents</source>
        <translation>电流的延迟</translation>
    </message>
    <message>
        <source>Field amplitude at the chip</source>
        <translation>霍尔芯片处的磁场幅值</translation>
    </message>
    <message>
        <source>Place of the chip in platen axes</source>
        <translation>霍尔芯片在动子坐标系中的位置</translation>
    </message>
    <message>
        <source>Error of the sensitivity along x&apos;</source>
        <translation>沿 x&apos; 的灵敏度误差</translation>
    </message>
    <message>
        <source>Error of the sensitivity along y&apos;</source>
        <translation>沿 y&apos; 的灵敏度误差</translation>
    </message>
    <message>
        <source>Share of the field along y&apos; in the reading of x&apos;</source>
        <translation>x&apos; 读数中 y&apos; 磁场的份额</translation>
    </message>
    <message>
        <source>Share of the field along x&apos; in the reading of y&apos;</source>
        <translation>y&apos; 读数中 x&apos; 磁场的份额</translation>
    </message>
    <message>
        <source>Offset of the reading of x&apos;</source>
        <translation>x&apos; 读数的零偏</translation>
    </message>
    <message>
        <source>Offset of the reading of y&apos;</source>
        <translation>y&apos; 读数的零偏</translation>
    </message>
    <message>
        <source>Field of coil 1 ... 6 at chip 1 along x&apos;, along y&apos;, at chip 2, ...</source>
        <translation>线圈 1 ... 6 在芯片 1 处沿 x&apos;、沿 y&apos;、在芯片 2 处……的磁场</translation>
    </message>
    <message>
        <source>Deviation of a reading: noise and what calibration leaves</source>
        <translation>读数的偏差：噪声和标定残差</translation>
    </message>
    <message>
        <source>m from where the mode began, or N</source>
        <translation>自模式开始起的 m，或 N</translation>
    </message>
    <message>
        <source>rad from where the mode began, or N*m</source>
        <translation>自模式开始起的 rad，或 N*m</translation>
    </message>
    <message>
        <source>Current of one coil in mode coil currents</source>
        <translation>线圈电流模式下单个线圈的电流</translation>
    </message>
    <message>
        <source>1 counts cells from the present one</source>
        <translation>1：从当前单元开始计数</translation>
    </message>
    <message>
        <source>Constant speed added in mode position, else effort</source>
        <translation>位置模式下叠加的恒定速度，否则为力或力矩</translation>
    </message>
    <message>
        <source>force constant</source>
        <translation>力常数</translation>
    </message>
    <message>
        <source>Planar six-coil positioner</source>
        <translation>六线圈平面定位台</translation>
    </message>
    <message>
        <source>True pose along x, known to the simulation only</source>
        <translation>沿 x 的真实位姿，仅仿真可知</translation>
    </message>
    <message>
        <source>True pose along y, known to the simulation only</source>
        <translation>沿 y 的真实位姿，仅仿真可知</translation>
    </message>
    <message>
        <source>True rotation, known to the simulation only</source>
        <translation>真实转角，仅仿真可知</translation>
    </message>
    <message>
        <source>True speed along x, known to the simulation only</source>
        <translation>沿 x 的真实速度，仅仿真可知</translation>
    </message>
    <message>
        <source>True speed along y, known to the simulation only</source>
        <translation>沿 y 的真实速度，仅仿真可知</translation>
    </message>
    <message>
        <source>True speed of rotation, known to the simulation only</source>
        <translation>真实转速，仅仿真可知</translation>
    </message>
    <message>
        <source>True force of the coils along x, known to the simulation only</source>
        <translation>线圈沿 x 的真实力，仅仿真可知</translation>
    </message>
    <message>
        <source>True force of the coils along y, known to the simulation only</source>
        <translation>线圈沿 y 的真实力，仅仿真可知</translation>
    </message>
    <message>
        <source>True torque of the coils, known to the simulation only</source>
        <translation>线圈的真实转矩，仅仿真可知</translation>
    </message>
    <message>
        <source>{}:1: column &apos;{}&apos; is in &apos;{}&apos;, but {} is in {}</source>
        <translation>{}:1: 列“{}”的单位是“{}”，但 {} 的单位是 {}</translation>
    </message>
    <message>
        <source>{}: signals[{}].unit: &apos;{}&apos; contradicts the column &apos;{}&apos;</source>
        <translation>{}: signals[{}].unit：“{}”与列“{}”矛盾</translation>
    </message>
    <message>
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: deg is an angle; degrees Celsius are written degC</source>
        <translation>列“{}”（“{}”）的单位：deg 是角度；摄氏度应写作 degC</translation>
    </message>
    <message>
        <source>is {}, but the parameters say {}/{} = {}</source>
        <translation>为 {}，但参数给出 {}/{} = {}</translation>
    </message>
    <message>
        <source>{}: &quot;parameters[{}]</source>
        <translation>{}: &quot;parameters[{}]</translation>
    </message>
    <message>
        <source>{} of the recording is in {}, not in {}</source>
        <translation>记录中的 {} 单位是 {}，不是 {}</translation>
    </message>
    <message>
        <source>a motor is identified from its angle and its current</source>
        <translation>电机由其角度和电流辨识</translation>
    </message>
    <message>
        <source>Rotor angle, unwrapped</source>
        <translation>转子角度，跨圈累计</translation>
    </message>
    <message>
        <source>Rotor speed, slope over 32 ms</source>
        <translation>转子转速，32 ms 内的斜率</translation>
    </message>
    <message>
        <source>Reference: rad in mode position, else A</source>
        <translation>参考值：位置模式下为 rad，否则为 A</translation>
    </message>
    <message>
        <source>Current amplitude commanded</source>
        <translation>电流幅值指令</translation>
    </message>
    <message>
        <source>Current commanded into phase {}</source>
        <translation>{} 相电流指令</translation>
    </message>
    <message>
        <source>Field at Hall sensor {}, not corrected</source>
        <translation>霍尔传感器 {} 处的磁场，未校正</translation>
    </message>
    <message>
        <source>Coil {}</source>
        <translation>线圈 {}</translation>
    </message>
    <message>
        <source>State of the board</source>
        <translation>控制板状态</translation>
    </message>
    <message>
        <source>Latched fault</source>
        <translation>已锁存的故障</translation>
    </message>
    <message>
        <source>Control cycles that saw a mixed parameter set</source>
        <translation>遇到混合参数组的控制周期数</translation>
    </message>
    <message>
        <source>Step or plateau, 0 = not running</source>
        <translation>阶梯或平台序号，0 = 未运行</translation>
    </message>
    <message>
        <source>1 while the generator runs</source>
        <translation>发生器运行时为 1</translation>
    </message>
    <message>
        <source>State of the capture</source>
        <translation>捕获状态</translation>
    </message>
    <message>
        <source>Device time of the trigger sample</source>
        <translation>触发样本的设备时间</translation>
    </message>
    <message>
        <source>Proportional gain</source>
        <translation>比例增益</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>积分增益</translation>
    </message>
    <message>
        <source>Derivative gain on the measured angle</source>
        <translation>作用于测得角度的微分增益</translation>
    </message>
    <message>
        <source>Set-point weight b of the proportional part</source>
        <translation>比例部分的设定值权重 b</translation>
    </message>
    <message>
        <source>Set-point weight c of the derivative part</source>
        <translation>微分部分的设定值权重 c</translation>
    </message>
    <message>
        <source>Time constant of the derivative&apos;s filter</source>
        <translation>微分滤波器的时间常数</translation>
    </message>
    <message>
        <source>Filter section (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2), d = z - 1</source>
        <translation>滤波环节 (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2)，d = z - 1</translation>
    </message>
    <message>
        <source>Coefficient b1 of the filter section</source>
        <translation>滤波环节的系数 b1</translation>
    </message>
    <message>
        <source>Coefficient b2 of the filter section</source>
        <translation>滤波环节的系数 b2</translation>
    </message>
    <message>
        <source>Coefficient a1 of the filter section; 0 switches it off</source>
        <translation>滤波环节的系数 a1；0 表示关闭</translation>
    </message>
    <message>
        <source>Coefficient a2 of the filter section</source>
        <translation>滤波环节的系数 a2</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>滤波器</translation>
    </message>
    <message>
        <source>0.9 K_f/phi, with the reference speed</source>
        <translation>0.9 K_f/phi，随参考转速的方向</translation>
    </message>
    <message>
        <source>Reference speed of full Coulomb feed-forward</source>
        <translation>库仑摩擦前馈达到满值的参考转速</translation>
    </message>
    <message>
        <source>Friction help at rest, 0.9 K_f/phi</source>
        <translation>静止时的摩擦补偿，0.9 K_f/phi</translation>
    </message>
    <message>
        <source>Error above which the friction help acts (0.16 degrees)</source>
        <translation>误差超过此值时摩擦补偿起作用（0.16 度）</translation>
    </message>
    <message>
        <source>Reference speed below which the friction help acts</source>
        <translation>参考转速低于此值时摩擦补偿起作用</translation>
    </message>
    <message>
        <source>Form of the control law</source>
        <translation>控制律形式</translation>
    </message>
    <message>
        <source>Largest current amplitude</source>
        <translation>最大电流幅值</translation>
    </message>
    <message>
        <source>Coil temperature that trips</source>
        <translation>触发保护的线圈温度</translation>
    </message>
    <message>
        <source>Largest excursion from the position at arming</source>
        <translation>相对使能时位置的最大偏移</translation>
    </message>
    <message>
        <source>Position window</source>
        <translation>位置窗口</translation>
    </message>
    <message>
        <source>Largest speed while armed</source>
        <translation>使能时的最大转速</translation>
    </message>
    <message>
        <source>Speed window</source>
        <translation>转速窗口</translation>
    </message>
    <message>
        <source>Subtract the field of the phase currents</source>
        <translation>减去相电流产生的磁场</translation>
    </message>
    <message>
        <source>Field of a phase current at its own sensor</source>
        <translation>相电流在其自身传感器处的磁场</translation>
    </message>
    <message>
        <source>Angle from the two fields</source>
        <translation>由两个磁场求角度</translation>
    </message>
    <message>
        <source>Delay of the position loop in its samples</source>
        <translation>位置回路的时延（样本数）</translation>
    </message>
    <message>
        <source>Commutate every n-th millisecond</source>
        <translation>每 n 毫秒换相一次</translation>
    </message>
    <message>
        <source>Commutation angle ahead by speed times this</source>
        <translation>换相角超前量 = 转速乘以此值</translation>
    </message>
    <message>
        <source>Offset of channel {}</source>
        <translation>通道 {} 的偏置</translation>
    </message>
    <message>
        <source>Amplitude of channel B over channel A</source>
        <translation>通道 B 与通道 A 的幅值比</translation>
    </message>
    <message>
        <source>Channel B sees sin(angle + quadrature)</source>
        <translation>通道 B 测得 sin(角度 + 正交误差)</translation>
    </message>
    <message>
        <source>Field amplitude at the sensors</source>
        <translation>传感器处的磁场幅值</translation>
    </message>
    <message>
        <source>Angle error map</source>
        <translation>角度误差表</translation>
    </message>
    <message>
        <source>Angle error map, cosine of order {}</source>
        <translation>角度误差表，{} 阶余弦</translation>
    </message>
    <message>
        <source>Angle error map, sine of order {}</source>
        <translation>角度误差表，{} 阶正弦</translation>
    </message>
    <message>
        <source>Arm the outputs</source>
        <translation>使能输出</translation>
    </message>
    <message>
        <source>What the set-point means</source>
        <translation>设定值的含义</translation>
    </message>
    <message>
        <source>A, or rad from the position at arming</source>
        <translation>A，或相对使能时位置的 rad</translation>
    </message>
    <message>
        <source>Silence of the host that stops the board</source>
        <translation>主机静默超过此时间则控制板停止</translation>
    </message>
    <message>
        <source>Write 1 to stop and latch</source>
        <translation>写入 1 停止并锁存</translation>
    </message>
    <message>
        <source>A lost master brings this calibration back</source>
        <translation>主机失联时恢复此标定</translation>
    </message>
    <message>
        <source>Shape of the reference</source>
        <translation>参考信号波形</translation>
    </message>
    <message>
        <source>rad or A; height of one step of the staircase, end of the ramp</source>
        <translation>rad 或 A；阶梯一级的高度，斜坡的终值</translation>
    </message>
    <message>
        <source>Slope of the ramp, rad/s or A/s</source>
        <translation>斜坡斜率，rad/s 或 A/s</translation>
    </message>
    <message>
        <source>Frequency of sine; first of chirp and multisine</source>
        <translation>正弦频率；扫频和多正弦的起始频率</translation>
    </message>
    <message>
        <source>Last frequency of chirp and multisine</source>
        <translation>扫频和多正弦的终止频率</translation>
    </message>
    <message>
        <source>Time of one step of the staircase</source>
        <translation>阶梯每级的时间</translation>
    </message>
    <message>
        <source>Steps of the staircase, lines of the multisine</source>
        <translation>阶梯级数，多正弦谱线数</translation>
    </message>
    <message>
        <source>Time until the generator ends</source>
        <translation>发生器运行的时间</translation>
    </message>
    <message>
        <source>Constant motion added: rad/s in mode position, else A</source>
        <translation>叠加的恒定运动：位置模式下为 rad/s，否则为 A</translation>
    </message>
    <message>
        <source>Phases of the multisine; 0 = Schroeder</source>
        <translation>多正弦相位；0 = Schroeder 相位</translation>
    </message>
    <message>
        <source>Number of plateaus</source>
        <translation>平台数</translation>
    </message>
    <message>
        <source>Time of one plateau</source>
        <translation>每个平台的时间</translation>
    </message>
    <message>
        <source>Signal of channel {} as handle (address/8), 255 = none</source>
        <translation>通道 {} 的信号编号（地址/8），255 = 无</translation>
    </message>
    <message>
        <source>What starts the capture</source>
        <translation>捕获的触发方式</translation>
    </message>
    <message>
        <source>Handle of the signal compared with the level</source>
        <translation>与电平比较的信号编号</translation>
    </message>
    <message>
        <source>Level of the trigger</source>
        <translation>触发电平</translation>
    </message>
    <message>
        <source>Direction of the crossing</source>
        <translation>穿越方向</translation>
    </message>
    <message>
        <source>Samples before the trigger</source>
        <translation>触发前的样本数</translation>
    </message>
    <message>
        <source>Milliseconds per sample</source>
        <translation>每个样本的毫秒数</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>feedforward</source>
        <translation>前馈</translation>
    </message>
    <message>
        <source>stiction</source>
        <translation>摩擦补偿</translation>
    </message>
    <message>
        <source>control</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>stray</source>
        <translation>杂散磁场</translation>
    </message>
    <message>
        <source>decode</source>
        <translation>角度解码</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>时延</translation>
    </message>
    <message>
        <source>commutation</source>
        <translation>换相</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>霍尔传感器</translation>
    </message>
    <message>
        <source>errormap</source>
        <translation>角度误差表</translation>
    </message>
    <message>
        <source>hb</source>
        <translation>控制板</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考信号发生器</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>capture</source>
        <translation>捕获</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>disarm</source>
        <translation>解除使能</translation>
    </message>
    <message>
        <source>stopped by command</source>
        <translation>由命令停止</translation>
    </message>
    <message>
        <source>stopped by watchdog</source>
        <translation>由看门狗停止</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>coil temperature above its limit</source>
        <translation>线圈温度超过限值</translation>
    </message>
    <message>
        <source>current above its limit</source>
        <translation>电流超过限值</translation>
    </message>
    <message>
        <source>speed above its window</source>
        <translation>转速超出窗口</translation>
    </message>
    <message>
        <source>position left its window</source>
        <translation>位置超出窗口</translation>
    </message>
    <message>
        <source>angle jumped (ambiguous decode)</source>
        <translation>角度跳变（解码不唯一）</translation>
    </message>
    <message>
        <source>sensor out of range</source>
        <translation>传感器超出范围</translation>
    </message>
    <message>
        <source>value not finite</source>
        <translation>数值不是有限数</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>positional</source>
        <translation>位置式</translation>
    </message>
    <message>
        <source>literal difference equation</source>
        <translation>原文差分方程</translation>
    </message>
    <message>
        <source>literal with clamped memory</source>
        <translation>原文差分方程，限幅记忆</translation>
    </message>
    <message>
        <source>arctangent</source>
        <translation>反正切</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>one sample</source>
        <translation>一个样本</translation>
    </message>
    <message>
        <source>two samples</source>
        <translation>两个样本</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>d-axis</source>
        <translation>d 轴</translation>
    </message>
    <message>
        <source>run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>multisine</source>
        <translation>多正弦</translation>
    </message>
    <message>
        <source>plateaus</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>填充中</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>full</source>
        <translation>已满</translation>
    </message>
    <message>
        <source>immediate</source>
        <translation>立即</translation>
    </message>
    <message>
        <source>level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>reference start</source>
        <translation>参考信号启动</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>transconductance</source>
        <translation>跨导</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>转矩</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>转动惯量</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>电阻</translation>
    </message>
    <message>
        <source>inductance</source>
        <translation>电感</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>比值</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>度</translation>
    </message>
    <message>
        <source>its</source>
        <translation>其</translation>
    </message>
    <message>
        <source>their</source>
        <translation>其</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>Designed: damping 0.06 at 15 rad/s, computed correctly</source>
        <translation>设计值：阻尼 0.06，15 rad/s，正确计算</translation>
    </message>
    <message>
        <source>Micro-step: error in degrees, 5 A/deg, 0.05 A/(deg s)</source>
        <translation>微步：误差以度计，5 A/°，0.05 A/(°·s)</translation>
    </message>
    <message>
        <source>Published gains read in degrees: 10 A/deg, 0.1 A/(deg s)</source>
        <translation>已发表的增益按度理解：10 A/°，0.1 A/(°·s)</translation>
    </message>
    <message>
        <source>Published: 10 A/rad, 0.1 A/(rad s)</source>
        <translation>已发表：10 A/rad，0.1 A/(rad s)</translation>
    </message>
    <message>
        <source>Recommended: feed-forward and micro-step assist</source>
        <translation>推荐：前馈和微步辅助</translation>
    </message>
    <message>
        <source>Two-phase Halbach-cylinder motor</source>
        <translation>两相 Halbach 圆筒电机</translation>
    </message>
    <message>
        <source>the feedback closes an algebraic loop with 1 + L = 0</source>
        <translation>反馈形成 1 + L = 0 的代数环</translation>
    </message>
    <message>
        <source>a step response needs at least two samples, each with its time</source>
        <translation>阶跃响应至少需要两个带时间的样本</translation>
    </message>
    <message>
        <source>the times of the step response are not ascending</source>
        <translation>阶跃响应的时间没有递增</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; is read only</source>
        <translation>参数“{}”只读</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>请去掉它</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; needs a finite number</source>
        <translation>参数“{}”需要有限数</translation>
    </message>
    <message>
        <source>give a value from {} to {}</source>
        <translation>请给出 {} 到 {} 的值</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; = {} is out of range</source>
        <translation>参数“{}”= {} 超出范围</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; = {} needs a whole number</source>
        <translation>参数“{}”= {} 需要整数</translation>
    </message>
    <message>
        <source>allowed is {} to {}</source>
        <translation>允许 {} 到 {}</translation>
    </message>
    <message>
        <source>count or state</source>
        <translation>计数或状态</translation>
    </message>
    <message>
        <source>angular speed</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>angular acceleration</source>
        <translation>角加速度</translation>
    </message>
    <message>
        <source>flux density</source>
        <translation>磁通密度</translation>
    </message>
    <message>
        <source>stray field per current</source>
        <translation>单位电流杂散磁场</translation>
    </message>
    <message>
        <source>temperature difference</source>
        <translation>温差</translation>
    </message>
    <message>
        <source>torque constant</source>
        <translation>转矩常数</translation>
    </message>
    <message>
        <source>viscous damping</source>
        <translation>粘性阻尼</translation>
    </message>
    <message>
        <source>acceleration per current</source>
        <translation>单位电流加速度</translation>
    </message>
    <message>
        <source>proportional gain</source>
        <translation>比例增益</translation>
    </message>
    <message>
        <source>integral gain</source>
        <translation>积分增益</translation>
    </message>
    <message>
        <source>derivative gain</source>
        <translation>微分增益</translation>
    </message>
    <message>
        <source>acceleration feed-forward</source>
        <translation>加速度前馈</translation>
    </message>
    <message>
        <source>current slope</source>
        <translation>电流变化率</translation>
    </message>
    <message>
        <source>lower zeta or omega, or use method bandwidth or phase-margin, which add derivative action</source>
        <translation>请降低 zeta 或 omega，或使用带微分作用的方法 bandwidth 或 phase-margin</translation>
    </message>
    <message>
        <source>method bandwidth needs a target bandwidth</source>
        <translation>方法 bandwidth 需要目标带宽</translation>
    </message>
    <message>
        <source>add --bandwidth-hz HZ</source>
        <translation>请加上 --bandwidth-hz HZ</translation>
    </message>
    <message>
        <source>a bandwidth of {} Hz is not possible with this motor at {} Hz sampling and {} samples of delay</source>
        <translation>在 {1} Hz 采样、{2} 个样本时延下，此电机无法达到 {0} Hz 带宽</translation>
    </message>
    <message>
        <source>choose {} to {} Hz</source>
        <translation>请选择 {} 到 {} Hz</translation>
    </message>
    <message>
        <source>method phase-margin needs a target margin</source>
        <translation>方法 phase-margin 需要目标裕度</translation>
    </message>
    <message>
        <source>add --phase-margin-deg DEG</source>
        <translation>请加上 --phase-margin-deg DEG</translation>
    </message>
    <message>
        <source>no position loop on this motor has a phase margin of {} deg and a gain margin of 2{}</source>
        <translation>此电机的任何位置回路都不能达到 {} 度的相位裕度和 2 倍的幅值裕度{}</translation>
    </message>
    <message>
        <source> at {} rad/s</source>
        <translation>（在 {} rad/s）</translation>
    </message>
    <message>
        <source>the target {} is not a finite number</source>
        <translation>目标 {} 不是有限数</translation>
    </message>
    <message>
        <source>method {} does not read the target {}</source>
        <translation>方法 {} 不使用目标 {}</translation>
    </message>
    <message>
        <source>leave it out, or choose the method that reads it</source>
        <translation>请去掉它，或选择使用它的方法</translation>
    </message>
    <message>
        <source>there is no design method &apos;{}&apos;</source>
        <translation>没有设计方法“{}”</translation>
    </message>
    <message>
        <source>choose one of: {}</source>
        <translation>请选择其一：{}</translation>
    </message>
    <message>
        <source>10 A/rad and 0.1 A/(rad s), as printed</source>
        <translation>10 A/rad 和 0.1 A/(rad s)，按所印</translation>
    </message>
    <message>
        <source>5 A/deg and 0.05 A/(deg s), for steps of a few tenths of a degree</source>
        <translation>5 A/° 和 0.05 A/(°·s)，用于零点几度的阶跃</translation>
    </message>
    <message>
        <source>a step needs a finite height that is not zero</source>
        <translation>阶跃需要非零的有限高度</translation>
    </message>
    <message>
        <source>a step response of {} s is not possible</source>
        <translation>{} s 的阶跃响应不可行</translation>
    </message>
    <message>
        <source>the series form has real zeros only, these gains have complex ones (T_i &lt; 4 T_d)</source>
        <translation>串联形式只有实零点，而这些增益有复零点（T_i &lt; 4 T_d）</translation>
    </message>
    <message>
        <source>a gain is not a finite number</source>
        <translation>某个增益不是有限数</translation>
    </message>
    <message>
        <source>a constant of the motor model is not a finite number</source>
        <translation>电机模型的某个常数不是有限数</translation>
    </message>
    <message>
        <source>a delay of {} samples is not between 0 and {}</source>
        <translation>{} 个样本的时延不在 0 和 {} 之间</translation>
    </message>
    <message>
        <source>it must be symmetric and positive semi-definite: identify the motor again</source>
        <translation>它必须对称且半正定：请重新辨识电机</translation>
    </message>
    <message>
        <source>{} draws are not between {} and {}</source>
        <translation>{} 次抽样不在 {} 和 {} 之间</translation>
    </message>
    <message>
        <source>the covariance does not have the size of the parameters</source>
        <translation>协方差的大小与参数不符</translation>
    </message>
    <message>
        <source>the model or its covariance holds a value that is not finite</source>
        <translation>模型或其协方差含有非有限值</translation>
    </message>
    <message>
        <source>the added inertia must be more than zero</source>
        <translation>附加惯量必须大于零</translation>
    </message>
    <message>
        <source>give it in kg*m^2, e.g. 2e-4</source>
        <translation>请以 kg*m^2 给出，例如 2e-4</translation>
    </message>
    <message>
        <source>the d-axis current does not change</source>
        <translation>d 轴电流没有变化</translation>
    </message>
    <message>
        <source>the ramp is too short</source>
        <translation>斜坡太短</translation>
    </message>
    <message>
        <source>the Hall readings do not change</source>
        <translation>霍尔读数没有变化</translation>
    </message>
    <message>
        <source>the Hall readings do not lie on an ellipse</source>
        <translation>霍尔读数不在椭圆上</translation>
    </message>
    <message>
        <source>too few Hall readings for an ellipse</source>
        <translation>霍尔读数太少，不足以拟合椭圆</translation>
    </message>
    <message>
        <source>no usable plateau</source>
        <translation>没有可用的平台</translation>
    </message>
    <message>
        <source>use currents above the breakaway current</source>
        <translation>请使用大于起动电流的电流</translation>
    </message>
    <message>
        <source>check the sign of the current and that the plateaus are steady</source>
        <translation>请检查电流的符号以及平台是否稳态</translation>
    </message>
    <message>
        <source>not identifiable</source>
        <translation>不可辨识</translation>
    </message>
    <message>
        <source>a value of the fit is not a finite number</source>
        <translation>拟合中的某个值不是有限数</translation>
    </message>
    <message>
        <source>measure more points</source>
        <translation>请测量更多的点</translation>
    </message>
    <message>
        <source>hold each current for a second or more, well above the breakaway current</source>
        <translation>每个电流请保持一秒以上，并明显高于起动电流</translation>
    </message>
    <message>
        <source>an angle of the recording is not a number</source>
        <translation>记录中的某个角度不是数字</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs over a wider range of speed</source>
        <translation>请在更宽的转速范围记录升速和自由减速</translation>
    </message>
    <message>
        <source>the columns of the recording differ in length</source>
        <translation>记录各列的长度不同</translation>
    </message>
    <message>
        <source>the time of the recording does not increase</source>
        <translation>记录的时间没有递增</translation>
    </message>
    <message>
        <source>a plateau has fewer than three samples</source>
        <translation>某个平台少于三个样本</translation>
    </message>
    <message>
        <source>a sample of a plateau is not a finite number</source>
        <translation>平台的某个样本不是有限数</translation>
    </message>
    <message>
        <source>a plateau is shorter than two windows of the steadiness test</source>
        <translation>某个平台短于稳态检验的两个窗口</translation>
    </message>
    <message>
        <source>a record has too few samples</source>
        <translation>某段记录的样本太少</translation>
    </message>
    <message>
        <source>no run-up and no coast-down</source>
        <translation>没有升速也没有自由减速</translation>
    </message>
    <message>
        <source>an angle is not a number</source>
        <translation>有一个角度不是数字</translation>
    </message>
    <message>
        <source>add a coast-down or a run-up at a second current</source>
        <translation>请增加一次自由减速或以第二个电流升速</translation>
    </message>
    <message>
        <source>the pre-warp frequency of {} rad/s is not between 0 and the Nyquist frequency of {} rad/s</source>
        <translation>预畸变频率 {} rad/s 不在 0 和奈奎斯特频率 {} rad/s 之间</translation>
    </message>
    <message>
        <source>the system is already sampled</source>
        <translation>系统已离散化</translation>
    </message>
    <message>
        <source>the bilinear rule has no solution: a pole lies at 2/T</source>
        <translation>双线性法无解：有极点位于 2/T</translation>
    </message>
    <message>
        <source>choose a shorter period</source>
        <translation>请选择更短的周期</translation>
    </message>
    <message>
        <source>the transfer function is already sampled</source>
        <translation>传递函数已离散化</translation>
    </message>
    <message>
        <source>a step response of {} s in steps of {} s is not possible</source>
        <translation>{} s、步长 {} s 的阶跃响应不可行</translation>
    </message>
    <message>
        <source>state space matrices do not fit: A {}x{}, B {}x{}, C {}x{}, D {}x{}</source>
        <translation>状态空间矩阵不匹配：A {}x{}、B {}x{}、C {}x{}、D {}x{}</translation>
    </message>
    <message>
        <source>a state space matrix holds a value that is not finite</source>
        <translation>状态空间矩阵含有非有限值</translation>
    </message>
    <message>
        <source>there is no path from input {} to output {}</source>
        <translation>从输入 {} 到输出 {} 没有通路</translation>
    </message>
    <message>
        <source>the sample period is not a finite number</source>
        <translation>采样周期不是有限数</translation>
    </message>
    <message>
        <source>a sample period of {} s is not possible</source>
        <translation>{} s 的采样周期不可行</translation>
    </message>
    <message>
        <source>give a positive period in seconds</source>
        <translation>请给出以秒为单位的正周期</translation>
    </message>
    <message>
        <source>sampled at {} s</source>
        <translation>以 {} s 采样</translation>
    </message>
    <message>
        <source>a system that is {} cannot be combined with one that is {}</source>
        <translation>{} 的系统不能与 {} 的系统组合</translation>
    </message>
    <message>
        <source>discretize one of them first</source>
        <translation>请先将其中之一离散化</translation>
    </message>
    <message>
        <source>a coefficient of the transfer function is not a finite number</source>
        <translation>传递函数的某个系数不是有限数</translation>
    </message>
    <message>
        <source>the denominator of the transfer function is zero</source>
        <translation>传递函数的分母为零</translation>
    </message>
    <message>
        <source>the transfer function has more zeros than poles</source>
        <translation>传递函数的零点多于极点</translation>
    </message>
    <message>
        <source>period or duration of the excitation is not a finite number</source>
        <translation>激励的周期或持续时间不是有限数</translation>
    </message>
    <message>
        <source>an excitation of {} s in steps of {} s is not possible</source>
        <translation>{} s、步长 {} s 的激励不可行</translation>
    </message>
    <message>
        <source>a frequency of the excitation is not a finite number</source>
        <translation>激励的某个频率不是有限数</translation>
    </message>
    <message>
        <source>{} to {} Hz does not lie between 0 and the Nyquist frequency of {} Hz</source>
        <translation>{} 到 {} Hz 不在 0 和奈奎斯特频率 {} Hz 之间</translation>
    </message>
    <message>
        <source>a binary sequence of {} stages held for {} samples is not possible</source>
        <translation>{} 级、每级保持 {} 个样本的二进制序列不可行</translation>
    </message>
    <message>
        <source>2 to 16 stages, 1 to 10000 samples</source>
        <translation>2 到 16 级，1 到 10000 个样本</translation>
    </message>
    <message>
        <source>the recording has no signal &apos;{}&apos;</source>
        <translation>记录中没有信号“{}”</translation>
    </message>
    <message>
        <source>the interval needs numbers</source>
        <translation>区间需要数字</translation>
    </message>
    <message>
        <source>give seconds, e.g. --from 1.5</source>
        <translation>请给出秒数，例如 --from 1.5</translation>
    </message>
    <message>
        <source>the recording has no rows in this interval</source>
        <translation>记录在此区间内没有数据行</translation>
    </message>
    <message>
        <source>{} {} and outside {} to {} {}</source>
        <translation>{} {}，超出 {} 到 {} {}</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>不是数字</translation>
    </message>
    <message>
        <source>stopped from here: {} was {} at {} s</source>
        <translation>由本机停止：{} 为 {}，时刻 {} s</translation>
    </message>
    <message>
        <source>find the cause, then clear the stop before arming again</source>
        <translation>请找出原因，再解除停止，然后重新使能</translation>
    </message>
    <message>
        <source>a recording begins with the line time_s,SIGNAL_UNIT,...; read other tables with &apos;halbench import&apos;</source>
        <translation>记录以 time_s,SIGNAL_UNIT,... 这一行开头；其他表格请用 &apos;halbench import&apos; 读取</translation>
    </message>
    <message>
        <source>the first column is not time_s</source>
        <translation>第一列不是 time_s</translation>
    </message>
    <message>
        <source>{} columns</source>
        <translation>{} 列</translation>
    </message>
    <message>
        <source>at most {} are read</source>
        <translation>最多读取 {} 个</translation>
    </message>
    <message>
        <source>a column has no name</source>
        <translation>有一列没有名称</translation>
    </message>
    <message>
        <source>{} fields where the header has {}</source>
        <translation>有 {} 个字段，而表头有 {} 个</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged</source>
        <translation>文件可能被截断或已损坏</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number</source>
        <translation>“{}”不是数字</translation>
    </message>
    <message>
        <source>the time does not increase</source>
        <translation>时间没有递增</translation>
    </message>
    <message>
        <source>sort the rows by time_s</source>
        <translation>请按 time_s 对各行排序</translation>
    </message>
    <message>
        <source>at most {} are read; cut the file into pieces that each begin with its first line</source>
        <translation>最多读取 {}；请把文件分成几段，每段都以原文件的首行开头</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>a recording begins with the line time_s,...</source>
        <translation>记录以 time_s,... 这一行开头</translation>
    </message>
    <message>
        <source>cannot read &apos;{}&apos;: {}</source>
        <translation>无法读取“{}”：{}</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>请检查路径</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed since it was recorded (SHA-256)</source>
        <translation>“{}”在记录之后被更改（SHA-256）</translation>
    </message>
    <message>
        <source>nothing was recorded before the interruption; the file can be removed</source>
        <translation>中断前没有记录任何内容；可删除该文件</translation>
    </message>
    <message>
        <source>recording interrupted</source>
        <translation>记录中断</translation>
    </message>
    <message>
        <source>{}: &quot;schema&quot; is not &quot;{}&quot;</source>
        <translation>{}：“schema”不是“{}”</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: {}</source>
        <translation>无法写入“{}”：{}</translation>
    </message>
    <message>
        <source>check that the folder can be written and the disk has room</source>
        <translation>请检查文件夹可写且磁盘有空间</translation>
    </message>
    <message>
        <source>cannot rename &apos;{}&apos; to &apos;{}&apos;: {}</source>
        <translation>无法将“{}”重命名为“{}”：{}</translation>
    </message>
    <message>
        <source>check that the folder can be written</source>
        <translation>请检查文件夹可写</translation>
    </message>
    <message>
        <source>cannot create the folder &apos;{}&apos;</source>
        <translation>无法创建文件夹“{}”</translation>
    </message>
    <message>
        <source>give a folder that can be written</source>
        <translation>请给出可写的文件夹</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a folder</source>
        <translation>“{}”是文件夹</translation>
    </message>
    <message>
        <source>give the name of a file</source>
        <translation>请给出文件名</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is being written by another program</source>
        <translation>“{}”正由其他程序写入</translation>
    </message>
    <message>
        <source>the recording has no parameter &apos;{}&apos;</source>
        <translation>记录中没有参数“{}”</translation>
    </message>
    <message>
        <source>list the names with: halbench describe replay:FILE</source>
        <translation>可用 halbench describe replay:FILE 列出名称</translation>
    </message>
    <message>
        <source>the recording ends at {} s</source>
        <translation>记录在 {} s 处结束</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has fewer than two rows</source>
        <translation>“{}”少于两行</translation>
    </message>
    <message>
        <source>give a recording with data</source>
        <translation>请给出含数据的记录</translation>
    </message>
    <message>
        <source>device address &apos;{}&apos;: {} at character {}</source>
        <translation>设备地址“{}”：{}（第 {} 个字符）</translation>
    </message>
    <message>
        <source>the device address has {} characters</source>
        <translation>设备地址有 {} 个字符</translation>
    </message>
    <message>
        <source>at most {} are allowed</source>
        <translation>最多允许 {} 个</translation>
    </message>
    <message>
        <source>the device address has a control character at character {}</source>
        <translation>设备地址第 {} 个字符是控制字符</translation>
    </message>
    <message>
        <source>write it like sim:htm?seed=7</source>
        <translation>写法如 sim:htm?seed=7</translation>
    </message>
    <message>
        <source>a scheme and &apos;:&apos; are missing</source>
        <translation>缺少协议名和“:”</translation>
    </message>
    <message>
        <source>write it like sim:htm, tcp:HOST:PORT or replay:FILE</source>
        <translation>写法如 sim:htm、tcp:HOST:PORT 或 replay:FILE</translation>
    </message>
    <message>
        <source>device address &apos;{}&apos;: unknown scheme &apos;{}&apos;</source>
        <translation>设备地址“{}”：未知的协议“{}”</translation>
    </message>
    <message>
        <source>known are {}</source>
        <translation>已知的有 {}</translation>
    </message>
    <message>
        <source>a key has letters, digits and &apos;_&apos; only</source>
        <translation>键只能含字母、数字和“_”</translation>
    </message>
    <message>
        <source>write options as KEY=VALUE</source>
        <translation>选项写成 KEY=VALUE</translation>
    </message>
    <message>
        <source>a key is missing</source>
        <translation>缺少键</translation>
    </message>
    <message>
        <source>write options as KEY=VALUE, joined by &apos;&amp;&apos;</source>
        <translation>选项写成 KEY=VALUE，用“&amp;”连接</translation>
    </message>
    <message>
        <source>&apos;=&apos; is missing</source>
        <translation>缺少“=”</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>缺少值</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is given twice</source>
        <translation>“{}”给出了两次</translation>
    </message>
    <message>
        <source>the address is missing</source>
        <translation>缺少地址</translation>
    </message>
    <message>
        <source>write it like sim:htm or tcp:HOST:PORT</source>
        <translation>写法如 sim:htm 或 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: unknown option &apos;{}&apos;</source>
        <translation>设备“{}”：未知的选项“{}”</translation>
    </message>
    <message>
        <source>must be &quot;{}&quot;</source>
        <translation>必须是“{}”</translation>
    </message>
    <message>
        <source>must name the model</source>
        <translation>必须指明型号</translation>
    </message>
    <message>
        <source>compare with resources/devices/htm.json</source>
        <translation>请与 resources/devices/htm.json 比较</translation>
    </message>
    <message>
        <source>is not a key of a profile</source>
        <translation>不是配置文件的键</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>必须是文本</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>必须是数字</translation>
    </message>
    <message>
        <source>must be a list of texts</source>
        <translation>必须是文本列表</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>必须是对象</translation>
    </message>
    <message>
        <source>correct the JSON</source>
        <translation>请改正该 JSON</translation>
    </message>
    <message>
        <source>{}: a profile is one JSON object</source>
        <translation>{}：配置文件是一个 JSON 对象</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>必须为 true 或 false</translation>
    </message>
    <message>
        <source>is not a key of an axis</source>
        <translation>不是轴的键</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>必须为正数</translation>
    </message>
    <message>
        <source>must be &quot;rad&quot; or &quot;m&quot;</source>
        <translation>必须为 &quot;rad&quot; 或 &quot;m&quot;</translation>
    </message>
    <message>
        <source>must be a unit of the program, e.g. &quot;N&quot;</source>
        <translation>必须是本程序的单位，例如 &quot;N&quot;</translation>
    </message>
    <message>
        <source>must be a role of this profile</source>
        <translation>必须是此配置文件中的角色</translation>
    </message>
    <message>
        <source>must be a list of axes</source>
        <translation>必须是轴的列表</translation>
    </message>
    <message>
        <source>must differ from the other axes</source>
        <translation>必须与其他轴不同</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>设备已被拔出</translation>
    </message>
    <message>
        <source>Connect it and open it again.</source>
        <translation>请连接后重新打开。</translation>
    </message>
    <message>
        <source>the loopback to the simulated board is closed</source>
        <translation>与仿真控制板的连接已关闭</translation>
    </message>
    <message>
        <source>Open the device again.</source>
        <translation>请重新打开设备。</translation>
    </message>
    <message>
        <source>True rotor angle, known to the simulation only</source>
        <translation>转子的真实角度，仅仿真可知</translation>
    </message>
    <message>
        <source>True rotor speed, known to the simulation only</source>
        <translation>转子的真实转速，仅仿真可知</translation>
    </message>
    <message>
        <source>there is no simulator &apos;sim:{}&apos;</source>
        <translation>没有仿真器“sim:{}”</translation>
    </message>
    <message>
        <source>Built simulators: {}.</source>
        <translation>已包含的仿真器：{}。</translation>
    </message>
    <message>
        <source>{}={} is out of range</source>
        <translation>{}={} 超出范围</translation>
    </message>
    <message>
        <source>{}={} is not a number</source>
        <translation>{}={} 不是数字</translation>
    </message>
    <message>
        <source>Write numbers like 2e-3. {}</source>
        <translation>数字写法如 2e-3。{}</translation>
    </message>
    <message>
        <source>seed={} is not a whole number</source>
        <translation>seed={} 不是整数</translation>
    </message>
    <message>
        <source>A seed is a whole number from 0 to 18446744073709551615. Known keys: {}.</source>
        <translation>种子是 0 到 18446744073709551615 的整数。已知的键：{}。</translation>
    </message>
    <message>
        <source>{}={} is unknown</source>
        <translation>{}={} 未知</translation>
    </message>
    <message>
        <source>Allowed: {}={} and {}={}. {}</source>
        <translation>允许：{}={} 和 {}={}。{}</translation>
    </message>
    <message>
        <source>{} has no override &apos;{}&apos;</source>
        <translation>{} 没有设置项“{}”</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not HOST:PORT</source>
        <translation>“{}”不是 HOST:PORT 的形式</translation>
    </message>
    <message>
        <source>write it like 127.0.0.1:5555 or [::1]:5555, port 0 to 65535</source>
        <translation>写法如 127.0.0.1:5555 或 [::1]:5555，端口 0 到 65535</translation>
    </message>
    <message>
        <source>cannot listen on {}: {}</source>
        <translation>无法监听 {}：{}</translation>
    </message>
    <message>
        <source>give an address of this machine and a free port, or port 0</source>
        <translation>请给出本机的地址和空闲端口，或端口 0</translation>
    </message>
    <message>
        <source>the connection is closed</source>
        <translation>连接已关闭</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware or report the description to its maker</source>
        <translation>请更新控制板固件，或将此描述报告给制造商</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>注释没有结束</translation>
    </message>
    <message>
        <source>a text is too long</source>
        <translation>文本太长</translation>
    </message>
    <message>
        <source>a text does not end</source>
        <translation>文本没有结束</translation>
    </message>
    <message>
        <source>a word is too long</source>
        <translation>单词太长</translation>
    </message>
    <message>
        <source>the name of a block is missing</source>
        <translation>缺少块的名称</translation>
    </message>
    <message>
        <source>{} is missing</source>
        <translation>缺少 {}</translation>
    </message>
    <message>
        <source>{} is missing (a text in quotes)</source>
        <translation>缺少 {}（引号中的文本）</translation>
    </message>
    <message>
        <source>{}: &apos;{}&apos; is not a number</source>
        <translation>{}：“{}”不是数字</translation>
    </message>
    <message>
        <source>{}: {} is not a whole number from 0 to {}</source>
        <translation>{}：{} 不是 0 到 {} 的整数</translation>
    </message>
    <message>
        <source>block {} does not end</source>
        <translation>块 {} 没有结束</translation>
    </message>
    <message>
        <source>blocks are nested deeper than {}</source>
        <translation>块的嵌套超过 {} 层</translation>
    </message>
    <message>
        <source>its conversion &apos;{}&apos; is {}</source>
        <translation>其换算“{}”{}</translation>
    </message>
    <message>
        <source>not of a supported kind</source>
        <translation>不是支持的种类</translation>
    </message>
    <message>
        <source>its lower limit is above the upper one; the type&apos;s limits are used</source>
        <translation>其下限高于上限；改用类型的限值</translation>
    </message>
    <message>
        <source>record a stream instead</source>
        <translation>请改为记录数据流</translation>
    </message>
    <message>
        <source>leave this signal out</source>
        <translation>请去掉此信号</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;</source>
        <translation>无法写入“{}”</translation>
    </message>
    <message>
        <source>cannot rename &apos;{}&apos;</source>
        <translation>无法重命名“{}”</translation>
    </message>
    <message>
        <source>make the folder writable</source>
        <translation>请使文件夹可写</translation>
    </message>
    <message>
        <source>the command queue was cleared</source>
        <translation>命令队列已清空</translation>
    </message>
    <message>
        <source>the board is busy</source>
        <translation>控制板忙</translation>
    </message>
    <message>
        <source>not possible while samples are streaming</source>
        <translation>数据流传输期间无法进行</translation>
    </message>
    <message>
        <source>not possible while the board is being programmed</source>
        <translation>控制板编程期间无法进行</translation>
    </message>
    <message>
        <source>the board does not know the command</source>
        <translation>控制板不认识该命令</translation>
    </message>
    <message>
        <source>the board found the command malformed</source>
        <translation>控制板认为命令格式错误</translation>
    </message>
    <message>
        <source>the value is out of range</source>
        <translation>数值超出范围</translation>
    </message>
    <message>
        <source>the memory is write protected</source>
        <translation>存储器有写保护</translation>
    </message>
    <message>
        <source>access is denied</source>
        <translation>访问被拒绝</translation>
    </message>
    <message>
        <source>access is locked</source>
        <translation>访问已锁定</translation>
    </message>
    <message>
        <source>the page does not exist</source>
        <translation>页不存在</translation>
    </message>
    <message>
        <source>the mode does not exist</source>
        <translation>模式不存在</translation>
    </message>
    <message>
        <source>the segment does not exist</source>
        <translation>段不存在</translation>
    </message>
    <message>
        <source>the commands came in the wrong order</source>
        <translation>命令顺序错误</translation>
    </message>
    <message>
        <source>the list of samples is not valid</source>
        <translation>采样列表无效</translation>
    </message>
    <message>
        <source>the board has no memory left</source>
        <translation>控制板内存不足</translation>
    </message>
    <message>
        <source>verification failed</source>
        <translation>验证失败</translation>
    </message>
    <message>
        <source>the resource is not accessible now</source>
        <translation>资源当前不可访问</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware or check the line</source>
        <translation>请更新控制板固件或检查线路</translation>
    </message>
    <message>
        <source>command {}</source>
        <translation>命令 {}</translation>
    </message>
    <message>
        <source>unknown error {}</source>
        <translation>未知错误 {}</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware</source>
        <translation>请更新控制板固件</translation>
    </message>
    <message>
        <source>time unit {} does not exist</source>
        <translation>时间单位 {} 不存在</translation>
    </message>
    <message>
        <source>these signals have no periodic event</source>
        <translation>这些信号没有周期事件</translation>
    </message>
    <message>
        <source>the device has no signal &apos;{}&apos;</source>
        <translation>设备没有信号“{}”</translation>
    </message>
    <message>
        <source>list the signals with: halbench describe DEVICE</source>
        <translation>可用 halbench describe DEVICE 列出信号</translation>
    </message>
    <message>
        <source>a stream needs at least one signal</source>
        <translation>数据流至少需要一个信号</translation>
    </message>
    <message>
        <source>name a signal</source>
        <translation>请指定一个信号</translation>
    </message>
    <message>
        <source>the device cannot send these signals at {} Hz</source>
        <translation>设备无法以 {} Hz 发送这些信号</translation>
    </message>
    <message>
        <source>the board&apos;s parameters are locked</source>
        <translation>控制板的参数已锁定</translation>
    </message>
    <message>
        <source>description of &apos;{}&apos; taken from the cache</source>
        <translation>“{}”的描述取自缓存</translation>
    </message>
    <message>
        <source>the board could not send all samples in time</source>
        <translation>控制板未能及时发送所有样本</translation>
    </message>
    <message>
        <source>the board stopped</source>
        <translation>控制板已停止</translation>
    </message>
    <message>
        <source>the board stopped the actuator: {}</source>
        <translation>控制板停止了执行器：{}</translation>
    </message>
    <message>
        <source>the board cannot be armed: {}</source>
        <translation>控制板无法使能：{}</translation>
    </message>
    <message>
        <source>remove the cause first</source>
        <translation>请先排除原因</translation>
    </message>
    <message>
        <source>this device cannot stream signals</source>
        <translation>此设备不能发送信号数据流</translation>
    </message>
    <message>
        <source>read single values instead</source>
        <translation>请改为读取单个值</translation>
    </message>
    <message>
        <source>link: {} packets, {} lost, {} damaged, {} commands repeated, round trip {} ms, at worst {} ms</source>
        <translation>链路：{} 个数据包，丢失 {}，损坏 {}，重发命令 {}，往返时间 {} ms，最长 {} ms</translation>
    </message>
    <message>
        <source>list the names with: halbench describe DEVICE</source>
        <translation>可用 halbench describe DEVICE 列出名称</translation>
    </message>
    <message>
        <source>the device has no parameter &apos;{}&apos;</source>
        <translation>设备没有参数“{}”</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos;: {}</source>
        <translation>参数“{}”：{}</translation>
    </message>
    <message>
        <source>check the board&apos;s state and limits</source>
        <translation>请检查控制板的状态和限值</translation>
    </message>
    <message>
        <source>check cable, power and address, then connect again</source>
        <translation>请检查电缆、电源和地址，然后重新连接</translation>
    </message>
    <message>
        <source>{} does not answer {}</source>
        <translation>{} 对 {} 没有应答</translation>
    </message>
    <message>
        <source>the board did not store its parameters within {} s</source>
        <translation>控制板在 {} s 内没有保存参数</translation>
    </message>
    <message>
        <source>try again, then read the values back</source>
        <translation>请重试，然后读回数值</translation>
    </message>
    <message>
        <source>the board needed more than {} s for its description</source>
        <translation>控制板传送描述用时超过 {} s</translation>
    </message>
    <message>
        <source>use a faster connection</source>
        <translation>请使用更快的连接</translation>
    </message>
    <message>
        <source>Every amplifier part must be positive and finite.</source>
        <translation>放大器的每个元件值都必须为有限正数。</translation>
    </message>
    <message>
        <source>Check resistors, capacitors and the coil&apos;s resistance and inductance.</source>
        <translation>请检查电阻、电容以及线圈的电阻和电感。</translation>
    </message>
    <message>
        <source>The decoded angle jumped by more than 90 degrees between two samples.</source>
        <translation>解码的角度在两个样本之间跳变超过 90 度。</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}{}{}. Known keys: {}.</source>
        <translation>允许：{} 到 {}{}{}{}。已知的键：{}。</translation>
    </message>
    <message>
        <source>{} is not a finite number</source>
        <translation>{} 不是有限数</translation>
    </message>
    <message>
        <source>{} = {} is out of range</source>
        <translation>{} = {} 超出范围</translation>
    </message>
    <message>
        <source>the planar positioner has no parameter &apos;{}&apos;</source>
        <translation>平面定位台没有参数“{}”</translation>
    </message>
    <message>
        <source>Make coil_width_mm smaller than {} mm.</source>
        <translation>请将 coil_width_mm 设为小于 {} mm。</translation>
    </message>
    <message>
        <source>the start pose lies beyond the stops at {} mm and {} mrad</source>
        <translation>起始位姿超出了 {} mm 和 {} mrad 处的限位</translation>
    </message>
    <message>
        <source>Keep x0_mm and y0_mm within {} mm, phi0_mrad within {} mrad.</source>
        <translation>请使 x0_mm 和 y0_mm 不超过 {} mm，phi0_mrad 不超过 {} mrad。</translation>
    </message>
    <message>
        <source>the motor has no parameter &apos;{}&apos;</source>
        <translation>电机没有参数“{}”</translation>
    </message>
    <message>
        <source>Known keys: {}.</source>
        <translation>已知的键：{}。</translation>
    </message>
    <message>
        <source>A Hall sensor setting is not a finite number.</source>
        <translation>某个霍尔传感器设置不是有限数。</translation>
    </message>
    <message>
        <source>A Hall sensor needs a positive sensitivity, noise of at least zero and a lower clip voltage below the upper one.</source>
        <translation>霍尔传感器需要正的灵敏度、不小于零的噪声，且下限幅电压低于上限幅电压。</translation>
    </message>
    <message>
        <source>A field harmonic needs an order of at least 1 and finite amplitudes.</source>
        <translation>磁场谐波的阶次至少为 1，幅值必须有限。</translation>
    </message>
    <message>
        <source>A constant belongs into the offset.</source>
        <translation>常数应归入偏置。</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>日期或时间</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>{}: is not PATH=VALUE</source>
        <translation>{}：不是“路径=值”的形式</translation>
    </message>
    <message>
        <source>write step.sweep.given.J=6e-4</source>
        <translation>请写成 step.sweep.given.J=6e-4</translation>
    </message>
    <message>
        <source>{}: there is no such step</source>
        <translation>{}：没有这个步骤</translation>
    </message>
    <message>
        <source>write step.NAME.KEY=VALUE with the name of a step of the file</source>
        <translation>请写成 step.NAME.KEY=VALUE，NAME 为文件中某个步骤的名称</translation>
    </message>
    <message>
        <source>{}:{}:{}: not valid JSON: {}</source>
        <translation>{}:{}:{}：不是有效的 JSON：{}</translation>
    </message>
    <message>
        <source>correct the file or write it again with --out</source>
        <translation>请改正该文件，或用 --out 重新写出</translation>
    </message>
    <message>
        <source>the result holds a value that is not a finite number at &apos;{}&apos;</source>
        <translation>结果在“{}”处含有非有限数</translation>
    </message>
    <message>
        <source>is &quot;{}&quot;, this version reads &quot;{}&quot;</source>
        <translation>为“{}”，此版本读取“{}”</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>is &quot;{}&quot;, not &quot;{}&quot;</source>
        <translation>为“{}”，而不是“{}”</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>必须是有限数</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to {}</source>
        <translation>必须是 0 到 {} 的整数</translation>
    </message>
    <message>
        <source>write the file again with &apos;halbench {} --out&apos;</source>
        <translation>请用“halbench {} --out”重新写出该文件</translation>
    </message>
    <message>
        <source>must be a list of lists of numbers</source>
        <translation>必须是数字列表的列表</translation>
    </message>
    <message>
        <source>must hold finite numbers</source>
        <translation>必须只含有限数</translation>
    </message>
    <message>
        <source>needs as many rows as names</source>
        <translation>行数必须与名称数相同</translation>
    </message>
    <message>
        <source>must be square</source>
        <translation>必须是方阵</translation>
    </message>
    <message>
        <source>needs a value and the two ends of its interval</source>
        <translation>需要一个值及其区间的两端</translation>
    </message>
    <message>
        <source>{}: cannot write: {}</source>
        <translation>{}：无法写入：{}</translation>
    </message>
    <message>
        <source>free space on the disk</source>
        <translation>请释放磁盘空间</translation>
    </message>
    <message>
        <source>choose another path or change its permissions</source>
        <translation>请选择其他路径或更改其权限</translation>
    </message>
    <message>
        <source>{}: is a folder</source>
        <translation>{}：是文件夹</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>请指定一个文件</translation>
    </message>
    <message>
        <source>{}: cannot read: {}</source>
        <translation>{}：无法读取：{}</translation>
    </message>
    <message>
        <source>{}: larger than 256 MB</source>
        <translation>{}：大于 256 MB</translation>
    </message>
    <message>
        <source>give a smaller file</source>
        <translation>请提供较小的文件</translation>
    </message>
    <message>
        <source>there is no preset &apos;{}&apos; for a device of model &apos;{}&apos;</source>
        <translation>型号为“{1}”的设备没有预设“{0}”</translation>
    </message>
    <message>
        <source>htm has {}</source>
        <translation>htm 有 {}</translation>
    </message>
    <message>
        <source>compare with resources/presets/htm/published.json</source>
        <translation>请与 resources/presets/htm/published.json 比较</translation>
    </message>
    <message>
        <source>must be &quot;halbench.preset/1&quot;</source>
        <translation>必须是“halbench.preset/1”</translation>
    </message>
    <message>
        <source>must be an object of numbers</source>
        <translation>必须是数字组成的对象</translation>
    </message>
    <message>
        <source>{}:{}:{}: not valid TOML: {}</source>
        <translation>{}:{}:{}：不是有效的 TOML：{}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a text</source>
        <translation>“{}”必须是文本</translation>
    </message>
    <message>
        <source>&apos;layout&apos; must be a table</source>
        <translation>“layout”必须是表</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list of tables, [[{}]]</source>
        <translation>“{}”必须是表的列表，[[{}]]</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[{}]] has name and document</source>
        <translation>未知的键“{}”；[[{}]] 只有 name 和 document</translation>
    </message>
    <message>
        <source>this version reads {}; the file is left as it is</source>
        <translation>此版本读取 {}；文件保持原样</translation>
    </message>
    <message>
        <source>{}: is not a Halbench project</source>
        <translation>{}：不是 Halbench 项目</translation>
    </message>
    <message>
        <source>a project begins with schema = &quot;{}&quot;</source>
        <translation>项目文件以 schema = &quot;{}&quot; 开头</translation>
    </message>
    <message>
        <source>choose another preset</source>
        <translation>请选择其他预设</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is too large for a preset</source>
        <translation>“{}”太大，不是预设文件</translation>
    </message>
    <message>
        <source>choose a preset file</source>
        <translation>请选择预设文件</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was written by a newer Halbench ({})</source>
        <translation>“{}”由较新的 Halbench 写成（{}）</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is for a device of model &apos;{}&apos;</source>
        <translation>“{}”适用于型号为“{}”的设备</translation>
    </message>
    <message>
        <source>this device is of model &apos;{}&apos;</source>
        <translation>此设备的型号为“{}”</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be the name of a preset</source>
        <translation>“{}”不能用作预设名称</translation>
    </message>
    <message>
        <source>use letters, digits, spaces, points and hyphens</source>
        <translation>请使用字母、数字、空格、点和连字符</translation>
    </message>
    <message>
        <source>check the folder and the space on the disk</source>
        <translation>请检查文件夹和磁盘空间</translation>
    </message>
    <message>
        <source>choose another folder or name</source>
        <translation>请选择其他文件夹或名称</translation>
    </message>
    <message>
        <source>K_P must be positive, K_I and K_D not negative</source>
        <translation>K_P 必须为正，K_I 和 K_D 不能为负</translation>
    </message>
    <message>
        <source>a current limit of {} A is not possible</source>
        <translation>电流限值 {} A 不可行</translation>
    </message>
    <message>
        <source>the stray field of the coils is not described by finite numbers</source>
        <translation>线圈杂散磁场的描述含有非有限数</translation>
    </message>
    <message>
        <source>the sampled loop is unstable: pole radius {}</source>
        <translation>采样回路不稳定：极点半径 {}</translation>
    </message>
    <message>
        <source>K_P = {} A/rad is {} times the limit of {} A/rad at this sampling and delay</source>
        <translation>K_P = {} A/rad 是在此采样和时延下极限值的 {} 倍（极限 {} A/rad）</translation>
    </message>
    <message>
        <source>friction holds the rotor within +-{} deg of the reference</source>
        <translation>摩擦使转子停在参考值 ±{} 度范围内</translation>
    </message>
    <message>
        <source>the micro-step assist or a larger K_P narrows the band</source>
        <translation>微步辅助或更大的 K_P 可缩小该带</translation>
    </message>
    <message>
        <source>switch the compensation on (stray.enabled)</source>
        <translation>请打开补偿（stray.enabled）</translation>
    </message>
    <message>
        <source>calibrate the stray field first</source>
        <translation>请先标定杂散磁场</translation>
    </message>
    <message>
        <source>calibrate the stray field again, or lower the gains</source>
        <translation>请重新标定杂散磁场，或降低增益</translation>
    </message>
    <message>
        <source>`halbench describe` lists the parameters.</source>
        <translation>“halbench describe”会列出参数。</translation>
    </message>
    <message>
        <source>{} reads {} after writing {}</source>
        <translation>{} 读回为 {}，而写入的是 {}</translation>
    </message>
    <message>
        <source>Verify with a step, ramp, sine or staircase.</source>
        <translation>请用阶跃、斜坡、正弦或阶梯来验证。</translation>
    </message>
    <message>
        <source>final error</source>
        <translation>终值误差</translation>
    </message>
    <message>
        <source>rms error</source>
        <translation>均方根误差</translation>
    </message>
    <message>
        <source>allow a higher current or speed</source>
        <translation>请允许更大的电流或转速</translation>
    </message>
    <message>
        <source>choose hall, stray, static-friction or all</source>
        <translation>请选择 hall、stray、static-friction 或 all</translation>
    </message>
    <message>
        <source>the currents of a calibration must lie in (0, 4] A</source>
        <translation>标定电流必须在 (0, 4] A 范围内</translation>
    </message>
    <message>
        <source>2 to 50 starts in each direction are possible</source>
        <translation>每个方向可起动 2 到 50 次</translation>
    </message>
    <message>
        <source>the rate must be more than zero</source>
        <translation>采样率必须大于零</translation>
    </message>
    <message>
        <source>Give e.g. --rate 1000.</source>
        <translation>例如给出 --rate 1000。</translation>
    </message>
    <message>
        <source>a capture at {} Hz is not possible</source>
        <translation>无法以 {} Hz 捕获</translation>
    </message>
    <message>
        <source>the rate must divide that of the loop, {} Hz; the nearest is {} Hz</source>
        <translation>采样率必须能整除回路频率 {} Hz；最接近的是 {} Hz</translation>
    </message>
    <message>
        <source>the share of rows before the trigger lies from 0 to below 1</source>
        <translation>触发前的数据比例必须从 0 到小于 1</translation>
    </message>
    <message>
        <source>Give e.g. --pre-trigger 0.25.</source>
        <translation>例如给出 --pre-trigger 0.25。</translation>
    </message>
    <message>
        <source>the wait for the trigger must be more than zero seconds</source>
        <translation>等待触发的时间必须大于零秒</translation>
    </message>
    <message>
        <source>Give e.g. --wait 10.</source>
        <translation>例如给出 --wait 10。</translation>
    </message>
    <message>
        <source>a capture takes 1 to {} signals</source>
        <translation>一次捕获可含 1 到 {} 个信号</translation>
    </message>
    <message>
        <source>record a stream for more</source>
        <translation>如需更多，请记录数据流</translation>
    </message>
    <message>
        <source>`halbench describe` lists the signals.</source>
        <translation>“halbench describe”会列出信号。</translation>
    </message>
    <message>
        <source>the signal &apos;{}&apos; is named twice</source>
        <translation>信号“{}”被指定了两次</translation>
    </message>
    <message>
        <source>Name every signal once.</source>
        <translation>每个信号只指定一次。</translation>
    </message>
    <message>
        <source>the trigger did not come within {} s</source>
        <translation>触发在 {} s 内没有到来</translation>
    </message>
    <message>
        <source>wait longer with --wait, or choose another --trigger</source>
        <translation>请用 --wait 等待更久，或选择其他 --trigger</translation>
    </message>
    <message>
        <source>another program may be using its capture; try again</source>
        <translation>可能有其他程序正在使用其捕获功能；请重试</translation>
    </message>
    <message>
        <source>a captured value is not a number</source>
        <translation>捕获的某个值不是数字</translation>
    </message>
    <message>
        <source>use now, reference, SIGNAL&gt;LEVEL (rising) or SIGNAL&lt;LEVEL (falling)</source>
        <translation>请使用 now、reference、SIGNAL&gt;LEVEL（上升）或 SIGNAL&lt;LEVEL（下降）</translation>
    </message>
    <message>
        <source>the level of a trigger is not finite</source>
        <translation>触发电平不是有限数</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>请给出一个数字</translation>
    </message>
    <message>
        <source>a coil temperature is not a number</source>
        <translation>有一个线圈温度不是数字</translation>
    </message>
    <message>
        <source>give it in SI units, e.g. J=5.5e-4</source>
        <translation>请用 SI 单位给出，例如 J=5.5e-4</translation>
    </message>
    <message>
        <source>{} = {} is not possible</source>
        <translation>{} = {} 不可行</translation>
    </message>
    <message>
        <source>it cannot be negative</source>
        <translation>不能为负</translation>
    </message>
    <message>
        <source>it must be more than zero</source>
        <translation>必须大于零</translation>
    </message>
    <message>
        <source>use J, c, Kf or phi</source>
        <translation>请使用 J、c、Kf 或 phi</translation>
    </message>
    <message>
        <source>the currents of the sweep are not finite numbers</source>
        <translation>扫描电流含有非有限数</translation>
    </message>
    <message>
        <source>write e.g. 1.6:4:0.2</source>
        <translation>例如写成 1.6:4:0.2</translation>
    </message>
    <message>
        <source>the sweep needs 0 &lt; FROM &lt;= TO and STEP &gt; 0</source>
        <translation>扫描要求 0 &lt; 起始 &lt;= 终止，且步长 &gt; 0</translation>
    </message>
    <message>
        <source>{} A is beyond the device&apos;s limit of {} A</source>
        <translation>{} A 超出设备限值 {} A</translation>
    </message>
    <message>
        <source>end the sweep at or below limit.current</source>
        <translation>扫描终止电流不要超过 limit.current</translation>
    </message>
    <message>
        <source>a sweep of more than 29 currents does not fit the board</source>
        <translation>超过 29 个电流的扫描无法装入控制板</translation>
    </message>
    <message>
        <source>use a larger step</source>
        <translation>请使用更大的步长</translation>
    </message>
    <message>
        <source>record at 100 Hz or more</source>
        <translation>请以 100 Hz 或更高的采样率记录</translation>
    </message>
    <message>
        <source>the rotor stopped</source>
        <translation>转子停住</translation>
    </message>
    <message>
        <source>slower than {} rad/s</source>
        <translation>低于 {} rad/s</translation>
    </message>
    <message>
        <source>not steady at its end</source>
        <translation>结束时未达稳态</translation>
    </message>
    <message>
        <source>friction differs between the directions by {} % of its mean</source>
        <translation>两个方向的摩擦相差平均值的 {} %</translation>
    </message>
    <message>
        <source>the mean of both directions is reported</source>
        <translation>给出的是两个方向的平均值</translation>
    </message>
    <message>
        <source>start the sweep further above the breakaway current</source>
        <translation>请让扫描从更高于起动电流处开始</translation>
    </message>
    <message>
        <source>{} rows of the recording were lost</source>
        <translation>记录丢失了 {} 行</translation>
    </message>
    <message>
        <source>run-ups and coast-downs could not be used: {}</source>
        <translation>升速和自由减速数据无法使用：{}</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs at 100 Hz or more</source>
        <translation>请以 100 Hz 或更高的采样率记录升速和自由减速</translation>
    </message>
    <message>
        <source>use a higher current, so that the coast-down above 3 rad/s lasts longer than 0.12 s, or a second current</source>
        <translation>请用更大的电流，使 3 rad/s 以上的自由减速超过 0.12 s，或增加第二个电流</translation>
    </message>
    <message>
        <source>calibrate the stray field and the Hall sensors, then identify again</source>
        <translation>请标定杂散磁场和霍尔传感器，然后重新辨识</translation>
    </message>
    <message>
        <source>ordinary and robust regression of the sweep differ by more than one standard error</source>
        <translation>扫描的普通回归与稳健回归相差超过一个标准误差</translation>
    </message>
    <message>
        <source>residuals keep their sign over neighbouring speeds (runs test, p = {})</source>
        <translation>相邻转速的残差符号相同（游程检验，p = {}）</translation>
    </message>
    <message>
        <source>add plateaus near it or repeat it</source>
        <translation>请在其附近增加平台或重测</translation>
    </message>
    <message>
        <source>c/phi is {} A*s/rad from plateaus and {} from all motion (p = {})</source>
        <translation>c/phi 由平台得 {} A*s/rad，由全部运动得 {}（p = {}）</translation>
    </message>
    <message>
        <source>friction may depend on speed</source>
        <translation>摩擦可能与转速有关</translation>
    </message>
    <message>
        <source>the given constants contradict the data (p = {})</source>
        <translation>给定的常数与数据矛盾（p = {}）</translation>
    </message>
    <message>
        <source>give the inertia (--given J=...) or the torque constant (--given phi=...), or repeat with a known inertia fixed to the rotor (--bare, --added-inertia)</source>
        <translation>请给出惯量 (--given J=...) 或转矩常数 (--given phi=...)，或在转子上固定已知惯量后重复 (--bare, --added-inertia)</translation>
    </message>
    <message>
        <source>identify the bare motor again without --given</source>
        <translation>请不用 --given 重新辨识裸电机</translation>
    </message>
    <message>
        <source>neither transients nor plateaus could be used: {}; {}</source>
        <translation>过渡过程和平台数据都无法使用：{}；{}</translation>
    </message>
    <message>
        <source>sweep forward</source>
        <translation>正向扫描</translation>
    </message>
    <message>
        <source>sweep reverse</source>
        <translation>反向扫描</translation>
    </message>
    <message>
        <source>coast-downs forward</source>
        <translation>正向自由减速</translation>
    </message>
    <message>
        <source>coast-downs reverse</source>
        <translation>反向自由减速</translation>
    </message>
    <message>
        <source>the speed limit leaves no usable speed</source>
        <translation>转速限值下没有可用的转速</translation>
    </message>
    <message>
        <source>allow e.g. 40 rad/s</source>
        <translation>例如允许 40 rad/s</translation>
    </message>
    <message>
        <source>0 to 16 coast-downs in each direction are possible</source>
        <translation>每个方向可自由减速 0 到 16 次</translation>
    </message>
    <message>
        <source>first motion</source>
        <translation>首次运动</translation>
    </message>
    <message>
        <source>steady speeds alone do not show the inertia: identify with run-ups and coast-downs, or give the constant that is known (--given J=...)</source>
        <translation>仅有稳态转速无法显示惯量：请用升速和自由减速辨识，或给出已知常数（--given J=...）</translation>
    </message>
    <message>
        <source>{} of the model is not a finite number</source>
        <translation>模型的 {} 不是有限数</translation>
    </message>
    <message>
        <source>the covariance of the model names {} values but is not {} x {}</source>
        <translation>模型的协方差列出 {} 个值，但不是 {} x {} 矩阵</translation>
    </message>
    <message>
        <source>the covariance of the model holds a value that is not finite</source>
        <translation>模型的协方差含有非有限值</translation>
    </message>
    <message>
        <source>Record longer or at a higher rate.</source>
        <translation>请记录更久或使用更高的采样率。</translation>
    </message>
    <message>
        <source>Repeat the move.</source>
        <translation>请重复该运动。</translation>
    </message>
    <message>
        <source>{} degrees</source>
        <translation>{} 度</translation>
    </message>
    <message>
        <source>a move of {} s is out of range</source>
        <translation>运动时间 {} s 超出范围</translation>
    </message>
    <message>
        <source>Allowed: 0.05 to 3600 s.</source>
        <translation>允许：0.05 到 3600 s。</translation>
    </message>
    <message>
        <source>{} of {} samples arrived</source>
        <translation>收到 {} 个样本，应为 {} 个</translation>
    </message>
    <message>
        <source>a {} needs {}</source>
        <translation>“{}”需要 {}</translation>
    </message>
    <message>
        <source>Add {}=... to the reference.</source>
        <translation>请在参考信号中加上 {}=...。</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not KEY=VALUE</source>
        <translation>“{}”不是 KEY=VALUE 的形式</translation>
    </message>
    <message>
        <source>Write a reference like step,amplitude_deg=100. Known keys: {}.</source>
        <translation>参考信号写法如 step,amplitude_deg=100。已知的键：{}。</translation>
    </message>
    <message>
        <source>Write {}=1.5.</source>
        <translation>请写成 {}=1.5。</translation>
    </message>
    <message>
        <source>there is no reference shape &apos;{}&apos;</source>
        <translation>没有参考波形“{}”</translation>
    </message>
    <message>
        <source>Known shapes: {}.</source>
        <translation>已知波形：{}。</translation>
    </message>
    <message>
        <source>a reference has no key &apos;{}&apos;</source>
        <translation>参考信号没有键“{}”</translation>
    </message>
    <message>
        <source>Allowed: {} to {}.</source>
        <translation>允许：{} 到 {}。</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}.</source>
        <translation>允许：{} 到 {}{}。</translation>
    </message>
    <message>
        <source>reference: &apos;{}&apos; is given twice</source>
        <translation>参考信号：“{}”给出了两次</translation>
    </message>
    <message>
        <source>{} is not a number at {} s</source>
        <translation>{} 在 {} s 处不是数字</translation>
    </message>
    <message>
        <source>the duration must be more than zero seconds</source>
        <translation>持续时间必须大于零秒</translation>
    </message>
    <message>
        <source>Give e.g. --duration 10.</source>
        <translation>例如给出 --duration 10。</translation>
    </message>
    <message>
        <source>Give e.g. --rate 100.</source>
        <translation>例如给出 --rate 100。</translation>
    </message>
    <message>
        <source>a duration of {} s at {} Hz is more than {} rows</source>
        <translation>{} s、{} Hz 超过 {} 行</translation>
    </message>
    <message>
        <source>Record in pieces or at a lower rate.</source>
        <translation>请分段记录或使用较低的采样率。</translation>
    </message>
    <message>
        <source>only {} of {} samples arrived</source>
        <translation>只收到 {} 个样本，应为 {} 个</translation>
    </message>
    <message>
        <source>{} of {} rows are missing</source>
        <translation>缺少 {} 行，共 {} 行</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>没有写入任何内容</translation>
    </message>
    <message>
        <source>a faster loop may be possible: method bandwidth or phase-margin</source>
        <translation>也许可以用更快的回路：方法 bandwidth 或 phase-margin</translation>
    </message>
    <message>
        <source>identify the motor to get its uncertainty</source>
        <translation>请辨识电机以得到其不确定度</translation>
    </message>
    <message>
        <source>identify more precisely, or choose a slower loop</source>
        <translation>请更精确地辨识，或选择较慢的回路</translation>
    </message>
    <message>
        <source>the set of gains lacks {}</source>
        <translation>增益组缺少 {}</translation>
    </message>
    <message>
        <source>{} = {} is negative</source>
        <translation>{} = {} 为负</translation>
    </message>
    <message>
        <source>the device has no parameter {}, which this set of gains needs</source>
        <translation>设备没有此增益组需要的参数 {}</translation>
    </message>
    <message>
        <source>choose a method without it: pole-placement or a preset</source>
        <translation>请选择不需要它的方法：pole-placement 或某个预设</translation>
    </message>
    <message>
        <source>no device is connected</source>
        <translation>没有连接设备</translation>
    </message>
    <message>
        <source>connect one first</source>
        <translation>请先连接设备</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>连接被拒绝</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>连接超时</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>连接被对方重置</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>网络不可达</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>没有到主机的路由</translation>
    </message>
    <message>
        <source>Name or service not known</source>
        <translation>名称或服务未知</translation>
    </message>
    <message>
        <source>Temporary failure in name resolution</source>
        <translation>域名解析暂时失败</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>地址已被使用</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有该文件或文件夹</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>权限不够</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间不足</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>不是文件夹</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>文件已存在</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>文件太大</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>只读文件系统</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>打开的文件过多</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入输出错误</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>未知错误</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: {}={}</source>
        <translation>设备“{}”：{}={}</translation>
    </message>
    <message>
        <source>use {}</source>
        <translation>请使用 {}</translation>
    </message>
    <message>
        <source>give a whole number from {} to {}</source>
        <translation>请给出 {} 到 {} 的整数</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: sync and escape are the same</source>
        <translation>设备“{}”：sync 与 escape 相同</translation>
    </message>
    <message>
        <source>{} is not open</source>
        <translation>{} 未打开</translation>
    </message>
    <message>
        <source>connect again</source>
        <translation>请重新连接</translation>
    </message>
    <message>
        <source>{} (process {})</source>
        <translation>{}（进程 {}）</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>某个程序</translation>
    </message>
    <message>
        <source>this program</source>
        <translation>本程序</translation>
    </message>
    <message>
        <source>, or join the group with &apos;sudo usermod -aG {} $USER&apos; and log in again</source>
        <translation>，或用“sudo usermod -aG {} $USER”加入用户组并重新登录</translation>
    </message>
    <message>
        <source>no permission to use {}</source>
        <translation>没有使用 {} 的权限</translation>
    </message>
    <message>
        <source>{} is in use by {}</source>
        <translation>{} 正被以下程序使用：{}</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>另一个程序</translation>
    </message>
    <message>
        <source>serial:{}: the device was unplugged or switched off</source>
        <translation>serial:{}：设备已被拔出或关闭</translation>
    </message>
    <message>
        <source>LEN byte</source>
        <translation>LEN 字节</translation>
    </message>
    <message>
        <source>LEN+CTR byte</source>
        <translation>LEN+CTR 字节</translation>
    </message>
    <message>
        <source>LEN+FILL byte</source>
        <translation>LEN+FILL 字节</translation>
    </message>
    <message>
        <source>LEN word</source>
        <translation>LEN 字</translation>
    </message>
    <message>
        <source>LEN+CTR words</source>
        <translation>LEN+CTR 字</translation>
    </message>
    <message>
        <source>LEN+FILL words</source>
        <translation>LEN+FILL 字</translation>
    </message>
    <message>
        <source>no checksum</source>
        <translation>无校验和</translation>
    </message>
    <message>
        <source>byte checksum</source>
        <translation>字节校验和</translation>
    </message>
    <message>
        <source>word checksum</source>
        <translation>字校验和</translation>
    </message>
    <message>
        <source>not framed</source>
        <translation>无帧</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a finite number</source>
        <translation>“{}”必须是有限数</translation>
    </message>
    <message>
        <source>a [[plot]] has both min and max, or neither; min is less than max</source>
        <translation>[[plot]] 要么同时有 min 和 max，要么都没有；min 小于 max</translation>
    </message>
    <message>
        <source>&apos;plot&apos; must be a list of tables, [[plot]]</source>
        <translation>“plot”必须是表的列表，[[plot]]</translation>
    </message>
    <message>
        <source>&apos;monitor&apos; must be a table</source>
        <translation>“monitor”必须是表</translation>
    </message>
    <message>
        <source>&apos;span_s&apos; must be more than 0</source>
        <translation>“span_s”必须大于 0</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>请重试</translation>
    </message>
    <message>
        <source>{} is open in another window (process {} on {})</source>
        <translation>{} 已在另一个窗口中打开（进程 {}，计算机 {}）</translation>
    </message>
    <message>
        <source>{}: the device was unplugged or switched off</source>
        <translation>{}：设备已拔出或已断电</translation>
    </message>
    <message>
        <source>{} cannot be opened: {}</source>
        <translation>无法打开 {}：{}</translation>
    </message>
    <message>
        <source>its serial port has no driver</source>
        <translation>其串口没有驱动程序</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>USB bulk device</source>
        <translation>USB 批量传输设备</translation>
    </message>
    <message>
        <source>HID device</source>
        <translation>HID 设备</translation>
    </message>
    <message>
        <source>no {} {} is plugged in</source>
        <translation>未接入 {} {}</translation>
    </message>
    <message>
        <source>{}: it is a {}</source>
        <translation>{}：该设备是 {}</translation>
    </message>
    <message>
        <source>name it {}</source>
        <translation>请使用名称 {}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not VID:PID[:SERIAL]</source>
        <translation>&apos;{}&apos; 不是 VID:PID[:序列号]</translation>
    </message>
    <message>
        <source>write both numbers in hexadecimal digits, like 1209:0001</source>
        <translation>请用十六进制写出两个编号，例如 1209:0001</translation>
    </message>
    <message>
        <source>several devices {} are plugged in</source>
        <translation>接入了多个 {} 设备</translation>
    </message>
    <message>
        <source>USB cannot be used</source>
        <translation>无法使用 USB</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>cannot be claimed</source>
        <translation>无法占用</translation>
    </message>
    <message>
        <source>Current of one plateau</source>
        <translation>一个平台的电流</translation>
    </message>
    <message>
        <source>output converter does not answer</source>
        <translation>输出转换器无应答</translation>
    </message>
    <message>
        <source>{}: {} is not a finite number</source>
        <translation>{}：{} 不是有限数</translation>
    </message>
    <message>
        <source>{}: {} is not from 0 to {}</source>
        <translation>{}：{} 不在 0 到 {} 之间</translation>
    </message>
    <message>
        <source>give milliseconds, e.g. 20</source>
        <translation>请给出毫秒数，例如 20</translation>
    </message>
    <message>
        <source>{}.unit&quot; is &quot;{}&quot;, which is no unit of a value in &quot;{}&quot;</source>
        <translation>{}.unit&quot; 是 &quot;{}&quot;，它不是以 &quot;{}&quot; 计的值的单位</translation>
    </message>
    <message>
        <source>it is a ratio: leave its unit empty</source>
        <translation>这是一个比值：单位留空</translation>
    </message>
    <message>
        <source>write the value in {} or a unit of the same quantity</source>
        <translation>请用 {} 或同一物理量的单位给出该值</translation>
    </message>
    <message>
        <source>{}.unit&quot; must be a text</source>
        <translation>{}.unit&quot; 必须是文本</translation>
    </message>
    <message>
        <source>write &quot;{}&quot;</source>
        <translation>请写 &quot;{}&quot;</translation>
    </message>
    <message>
        <source>the board ran firmware &apos;{}&apos;, but its description was of &apos;{}&apos;: names may have led to wrong values</source>
        <translation>电路板运行固件“{}”，但其描述文件属于“{}”：名称可能指向了错误的值</translation>
    </message>
    <message>
        <source>the configuration was read from the device &apos;{}&apos;, this one is &apos;{}&apos;</source>
        <translation>该配置读自设备“{}”，而此设备是“{}”</translation>
    </message>
    <message>
        <source>the configuration was read from firmware &apos;{}&apos;, this device runs &apos;{}&apos;</source>
        <translation>该配置读自固件“{}”，而此设备运行“{}”</translation>
    </message>
    <message>
        <source>the configuration has no value for &apos;{}&apos;</source>
        <translation>配置中没有“{}”的值</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be restored: {}</source>
        <translation>无法恢复“{}”：{}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was written by a newer Halbench</source>
        <translation>“{}”由更新版本的 Halbench 写入</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a configuration; expected &apos;{}&apos;</source>
        <translation>“{}”不是配置；应为“{}”</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a table, [{}]</source>
        <translation>“{}”必须是表，[{}]</translation>
    </message>
    <message>
        <source>&apos;{}&apos; of &apos;{}&apos; is unknown; a row has value and unit</source>
        <translation>“{}”（属于“{}”）未知；一行只有 value 和 unit</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no value</source>
        <translation>“{}”没有值</translation>
    </message>
    <message>
        <source>the value of &apos;{}&apos; must be a finite number</source>
        <translation>“{}”的值必须是有限数</translation>
    </message>
    <message>
        <source>there is no schema = &quot;{}&quot;</source>
        <translation>缺少 schema = &quot;{}&quot;</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;</source>
        <translation>未知键“{}”</translation>
    </message>
    <message>
        <source>&apos;given&apos; must be a table</source>
        <translation>&apos;given&apos; 必须是表</translation>
    </message>
    <message>
        <source>given: {}</source>
        <translation>given：{}</translation>
    </message>
    <message>
        <source>one row of the recording was lost</source>
        <translation>记录丢失了一行</translation>
    </message>
    <message>
        <source>another device answers at {}: {} instead of {}</source>
        <translation>在 {} 应答的是另一台设备：{}，而不是 {}</translation>
    </message>
    <message>
        <source>no device with the serial number &apos;{}&apos; is plugged in</source>
        <translation>未插入序列号为 &apos;{}&apos; 的设备</translation>
    </message>
    <message>
        <source>several ports have the serial number &apos;{}&apos;: {} and {}</source>
        <translation>多个端口的序列号为 &apos;{}&apos;：{} 和 {}</translation>
    </message>
    <message>
        <source>name one of them</source>
        <translation>请指定其中一个</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>连接已断开</translation>
    </message>
    <message>
        <source>connection back</source>
        <translation>连接已恢复</translation>
    </message>
    <message>
        <source>the description &apos;{}&apos; cannot be read: {}</source>
        <translation>无法读取描述文件 &apos;{}&apos;：{}</translation>
    </message>
    <message>
        <source>known are baud, dtr, low_latency, framing, header, checksum, sync, escape, a2l</source>
        <translation>已知的有 baud、dtr、low_latency、framing、header、checksum、sync、escape、a2l</translation>
    </message>
    <message>
        <source>no udev runs here, so that rules have no effect: allow it with &apos;sudo chmod a+rw {}&apos; each time it was plugged in</source>
        <translation>此处没有运行 udev，规则不起作用：每次插上后请用 &apos;sudo chmod a+rw {}&apos; 允许访问</translation>
    </message>
    <message>
        <source>give the A2L file that belongs to it: DEVICE?a2l=FILE</source>
        <translation>请给出其 A2L 文件：设备?a2l=文件</translation>
    </message>
    <message>
        <source>overlap, confidence and segment must be finite numbers</source>
        <translation>重叠、置信度和分段必须是有限数</translation>
    </message>
    <message>
        <source>an overlap of {} is not possible</source>
        <translation>重叠不能为 {}</translation>
    </message>
    <message>
        <source>give a ratio from 0 to 0.95; 0.5 is usual, 0.75 for flat-top and blackman-harris</source>
        <translation>请给出 0 到 0.95 的比值；通常为 0.5，flat-top 和 blackman-harris 为 0.75</translation>
    </message>
    <message>
        <source>a confidence of {} is not between 0 and 1</source>
        <translation>置信度 {} 不在 0 与 1 之间</translation>
    </message>
    <message>
        <source>0.95 is usual</source>
        <translation>通常为 0.95</translation>
    </message>
    <message>
        <source>a segment of {} s has fewer than {} rows</source>
        <translation>{} s 的分段少于 {} 行</translation>
    </message>
    <message>
        <source>give at least {} s</source>
        <translation>请至少给出 {} s</translation>
    </message>
    <message>
        <source>give a shorter segment, or record longer</source>
        <translation>请给出更短的分段，或记录更长时间</translation>
    </message>
    <message>
        <source>this version reads .csv, .mf4 and .csv.partial (an interrupted recording)</source>
        <translation>此版本读取 .csv、.mf4 和 .csv.partial（中断的记录）</translation>
    </message>
    <message>
        <source>line {}: {}</source>
        <translation>第 {} 行：{}</translation>
    </message>
    <message>
        <source>recording of {} {}</source>
        <translation>{} {} 的记录</translation>
    </message>
    <message>
        <source>written by Halbench</source>
        <translation>由 Halbench 写入</translation>
    </message>
    <message>
        <source>Halbench maintainers</source>
        <translation>Halbench 维护者</translation>
    </message>
    <message>
        <source>a parameter was changed</source>
        <translation>参数已更改</translation>
    </message>
    <message>
        <source>it is linked more than once</source>
        <translation>它被链接了不止一次</translation>
    </message>
    <message>
        <source>the file is not finalised</source>
        <translation>文件未完成</translation>
    </message>
    <message>
        <source>version {}</source>
        <translation>版本 {}</translation>
    </message>
    <message>
        <source>only version 410 is read</source>
        <translation>只读取版本 410</translation>
    </message>
    <message>
        <source>the file is not sorted or has several groups</source>
        <translation>文件未排序或含有多个组</translation>
    </message>
    <message>
        <source>it has flags, invalidation bits or a neighbour</source>
        <translation>它带有标志、无效位或相邻块</translation>
    </message>
    <message>
        <source>it is of another kind than time and 64-bit floats</source>
        <translation>它的类型不是时间和 64 位浮点数</translation>
    </message>
    <message>
        <source>row {}: the time does not increase</source>
        <translation>第 {} 行：时间没有递增</translation>
    </message>
    <message>
        <source>this version writes .csv, .mf4 and .mat</source>
        <translation>此版本写入 .csv、.mf4 和 .mat</translation>
    </message>
    <message>
        <source>MATLAB 5.0 MAT-file, written by Halbench</source>
        <translation>MATLAB 5.0 MAT 文件，由 Halbench 写入</translation>
    </message>
    <message>
        <source>give a finite number</source>
        <translation>请给出有限数</translation>
    </message>
    <message>
        <source>a trigger without a source</source>
        <translation>触发没有信号源</translation>
    </message>
    <message>
        <source>give the name of a signal</source>
        <translation>请给出信号名称</translation>
    </message>
    <message>
        <source>level, hysteresis and times of a trigger must be finite numbers</source>
        <translation>触发的电平、迟滞和时间必须是有限数</translation>
    </message>
    <message>
        <source>a hysteresis of {} is negative</source>
        <translation>迟滞 {} 为负</translation>
    </message>
    <message>
        <source>give 0 or how far the signal must have been on the other side of the level</source>
        <translation>请给出 0，或信号须在电平另一侧达到的距离</translation>
    </message>
    <message>
        <source>a pre-trigger share of {} is not between 0 and 1</source>
        <translation>预触发比例 {} 不在 0 与 1 之间</translation>
    </message>
    <message>
        <source>0.25 shows a quarter of the window before the trigger</source>
        <translation>0.25 表示窗口的四分之一在触发之前</translation>
    </message>
    <message>
        <source>a trigger&apos;s window of {} s, hold-off of {} s and longest wait of {} s are not possible</source>
        <translation>触发窗口 {} s、释抑 {} s 和最长等待 {} s 不可行</translation>
    </message>
    <message>
        <source>the window and the wait are longer than 0, the hold-off is not negative</source>
        <translation>窗口和等待须大于 0，释抑不能为负</translation>
    </message>
    <message>
        <source>the dead time is not a finite number</source>
        <translation>纯滞后时间不是有限数</translation>
    </message>
    <message>
        <source>a dead time of {} s is not possible</source>
        <translation>{} s 的纯滞后时间不可能</translation>
    </message>
    <message>
        <source>a system with {} s of dead time cannot be added to one with {} s</source>
        <translation>纯滞后为 {} s 的系统不能与纯滞后为 {} s 的系统相加</translation>
    </message>
    <message>
        <source>discretize both, or approximate their dead times, first</source>
        <translation>请先将二者离散化，或近似其纯滞后</translation>
    </message>
    <message>
        <source>Good: robustly stable</source>
        <translation>良好：鲁棒稳定</translation>
    </message>
    <message>
        <source>Good: stable</source>
        <translation>良好：稳定</translation>
    </message>
    <message>
        <source>the model was identified on the {} &apos;{}&apos;, this device is the {} &apos;{}&apos;</source>
        <translation>该模型是在 {} “{}”上辨识的，而此设备是 {} “{}”</translation>
    </message>
    <message>
        <source>the model was identified on &apos;{}&apos; with other overrides than this device has</source>
        <translation>该模型是在“{}”上以不同的覆盖参数辨识的</translation>
    </message>
    <message>
        <source>it is the console of this machine</source>
        <translation>它是本机的控制台</translation>
    </message>
    <message>
        <source>load it: sudo modprobe {}</source>
        <translation>加载驱动：sudo modprobe {}</translation>
    </message>
    <message>
        <source>held by the kernel driver &apos;{}&apos;</source>
        <translation>被内核驱动 &apos;{}&apos; 占用</translation>
    </message>
    <message>
        <source>{}: the system has no memory left for USB transfers</source>
        <translation>{}：系统没有更多内存用于 USB 传输</translation>
    </message>
    <message>
        <source>close other programs that use USB, or raise /sys/module/usbcore/parameters/usbfs_memory_mb</source>
        <translation>请关闭其他使用 USB 的程序，或增大 /sys/module/usbcore/parameters/usbfs_memory_mb</translation>
    </message>
    <message>
        <source>the transfer failed</source>
        <translation>传输失败</translation>
    </message>
    <message>
        <source>unload the driver: sudo modprobe -r {}</source>
        <translation>卸载驱动：sudo modprobe -r {}</translation>
    </message>
    <message>
        <source>the rotor ended at {} instead of {} degrees</source>
        <translation>转子停在 {} 度，而不是 {} 度</translation>
    </message>
    <message>
        <source>axis {} ended at {} instead of {} {}</source>
        <translation>轴 {} 停在 {}，而不是 {} {}</translation>
    </message>
    <message>
        <source>a move of {} {} leaves the window of {} {} of axis {}</source>
        <translation>移动 {} {} 会超出 {} {} 的窗口（轴 {}）</translation>
    </message>
    <message>
        <source>the limit or level of a nonlinear element must be positive, its hysteresis not negative</source>
        <translation>非线性环节的限值或幅度必须为正，其迟滞不得为负</translation>
    </message>
    <message>
        <source>a root locus needs a loop with poles and a gain</source>
        <translation>根轨迹需要一个具有极点和增益的回路</translation>
    </message>
    <message>
        <source>the largest gain of a root locus, {}, is not positive</source>
        <translation>根轨迹的最大增益 {} 不是正数</translation>
    </message>
    <message>
        <source>the impulse response of this system begins with an impulse</source>
        <translation>该系统的脉冲响应以一个脉冲开始</translation>
    </message>
    <message>
        <source>choose another rule, or add the filter that every real system has</source>
        <translation>请选择其他规则，或加入每个真实系统都有的滤波器</translation>
    </message>
    <message>
        <source>a pole lies at zero or on the negative real axis: choose Tustin, or take delays out first</source>
        <translation>有极点位于零点或负实轴：请选择 Tustin，或先去除延迟</translation>
    </message>
    <message>
        <source>poles and zeros can only be matched for one input and one output</source>
        <translation>只有单输入单输出时才能匹配零极点</translation>
    </message>
    <message>
        <source>the system is already continuous</source>
        <translation>系统已经是连续的</translation>
    </message>
    <message>
        <source>a response needs a system with one input and one output</source>
        <translation>响应需要单输入单输出系统</translation>
    </message>
    <message>
        <source>a response needs ascending times, each with its input</source>
        <translation>响应需要递增的时间，且每个时间都有输入</translation>
    </message>
    <message>
        <source>systems with {} and {} signals cannot be connected</source>
        <translation>具有 {} 个和 {} 个信号的系统不能相连</translation>
    </message>
    <message>
        <source>a zero, a pole or the gain of a system is not a finite number</source>
        <translation>系统的某个零点、极点或增益不是有限数</translation>
    </message>
    <message>
        <source>a complex zero or pole lacks its conjugate partner</source>
        <translation>某个复数零点或极点缺少其共轭</translation>
    </message>
    <message>
        <source>a figure of the filter is not a finite number</source>
        <translation>滤波器的某个参数不是有限数</translation>
    </message>
    <message>
        <source>the design is unstable in the sampled loop</source>
        <translation>该设计在采样回路中不稳定</translation>
    </message>
    <message>
        <source>the current limit must be positive</source>
        <translation>电流限值必须为正</translation>
    </message>
    <message>
        <source>the weights of the regulator do not fit the system</source>
        <translation>调节器的权重与系统不符</translation>
    </message>
    <message>
        <source>no regulator stabilises this system with these weights</source>
        <translation>采用这些权重没有调节器能使该系统稳定</translation>
    </message>
    <message>
        <source>a constant of the process model is not a finite number</source>
        <translation>过程模型的某个常数不是有限数</translation>
    </message>
    <message>
        <source>this tuning rule needs a process with a gain and a lag, and a time to close in</source>
        <translation>该整定规则需要具有增益和滞后的过程，以及闭环时间</translation>
    </message>
    <message>
        <source>use SIMC or pole placement</source>
        <translation>请使用 SIMC 或极点配置</translation>
    </message>
    <message>
        <source>must be &apos;{}&apos;, &apos;{}&apos; or &apos;{}&apos;</source>
        <translation>必须是 &apos;{}&apos;、&apos;{}&apos; 或 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>&apos;trigger&apos; must be a table, [monitor.trigger]</source>
        <translation>&apos;trigger&apos; 必须是表，[monitor.trigger]</translation>
    </message>
    <message>
        <source>of a trigger window_s is more than 0, hysteresis and hold_off_s are not negative, pre_trigger_ratio is from 0 to 1</source>
        <translation>触发的 window_s 大于 0，hysteresis 和 hold_off_s 不为负，pre_trigger_ratio 在 0 到 1 之间</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be true or false</source>
        <translation>&apos;{}&apos; 必须是 true 或 false</translation>
    </message>
    <message>
        <source>0 stops, 1 starts the generator, 2 to 255 start it once</source>
        <translation>0 停止，1 启动信号发生器，2 到 255 只启动一次</translation>
    </message>
    <message>
        <source>0 stops, 1 starts the capture, 2 to 255 start it once</source>
        <translation>0 停止，1 启动采集，2 到 255 只启动一次</translation>
    </message>
    <message>
        <source>SIMC, the internal-model rule of Skogestad, for lag and dead time</source>
        <translation>SIMC，Skogestad 的内模整定规则，适用于滞后加死区时间</translation>
    </message>
    <message>
        <source>the gains of this rule, K_P = {} A/rad, K_I = {} A/(rad s) and K_D = {} A s/rad, are unstable in the sampled loop: pole radius {}</source>
        <translation>该规则给出的增益 K_P = {} A/rad、K_I = {} A/(rad s)、K_D = {} A s/rad 在采样回路中不稳定：极点半径 {}</translation>
    </message>
    <message>
        <source>use method bandwidth, phase-margin or lqr</source>
        <translation>请使用方法 bandwidth、phase-margin 或 lqr</translation>
    </message>
    <message>
        <source>a design needs a name</source>
        <translation>设计需要一个名称</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>请选择其他名称</translation>
    </message>
    <message>
        <source>measure at least {}</source>
        <translation>至少测量 {} 个</translation>
    </message>
    <message>
        <source>the excited lines do not ascend below half the rate</source>
        <translation>被激励的谱线没有递增，或超过采样率的一半</translation>
    </message>
    <message>
        <source>the excitation did not reach the plant</source>
        <translation>激励没有到达被控对象</translation>
    </message>
    <message>
        <source>too few usable frequencies for a fit of the rotor</source>
        <translation>可用频率太少，无法拟合转子</translation>
    </message>
    <message>
        <source>use a smaller amplitude</source>
        <translation>使用更小的幅值</translation>
    </message>
    <message>
        <source>measure more frequencies, from 0.5 Hz or lower</source>
        <translation>从 0.5 Hz 或更低开始测量更多频率</translation>
    </message>
    <message>
        <source>allowed: {} to {}</source>
        <translation>允许：{} 至 {}</translation>
    </message>
    <message>
        <source>lowest frequency in Hz</source>
        <translation>最低频率（Hz）</translation>
    </message>
    <message>
        <source>highest frequency in Hz</source>
        <translation>最高频率（Hz）</translation>
    </message>
    <message>
        <source>number of periods</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>amplitude in rad</source>
        <translation>幅值（rad）</translation>
    </message>
    <message>
        <source>use at least {} rad/s in either direction</source>
        <translation>任一方向至少使用 {} rad/s</translation>
    </message>
    <message>
        <source>base speed in rad/s</source>
        <translation>基础转速（rad/s）</translation>
    </message>
    <message>
        <source>set control.law=0 first; nothing was armed</source>
        <translation>先设置 control.law=0；未使能任何设备</translation>
    </message>
    <message>
        <source>use a stepped sine</source>
        <translation>使用步进正弦</translation>
    </message>
    <message>
        <source>a frequency response needs a board with a position loop of its own</source>
        <translation>频率响应需要自带位置环的控制板</translation>
    </message>
    <message>
        <source>the name &apos;{}&apos; is taken</source>
        <translation>名称 &apos;{}&apos; 已被占用</translation>
    </message>
    <message>
        <source>&apos;{}&apos; defines no signal</source>
        <translation>“{}”没有定义信号</translation>
    </message>
    <message>
        <source>write NAME = EXPRESSION or NAME [UNIT] = EXPRESSION</source>
        <translation>请写 名称 = 表达式 或 名称 [单位] = 表达式</translation>
    </message>
    <message>
        <source>operators are + - * / ^ and comparisons, functions sin, cos, atan2, sqrt, abs, exp, ln, min, max</source>
        <translation>运算符为 + - * / ^ 和比较，函数为 sin、cos、atan2、sqrt、abs、exp、ln、min、max</translation>
    </message>
    <message>
        <source>the expression has several results</source>
        <translation>表达式有多个结果</translation>
    </message>
    <message>
        <source>&apos;derived&apos; must be a list of tables, [[derived]]</source>
        <translation>&apos;derived&apos; 必须是表的列表，[[derived]]</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[derived]] has name, expression, unit</source>
        <translation>未知的键 &apos;{}&apos;；[[derived]] 有 name、expression、unit</translation>
    </message>
    <message>
        <source>a [[derived]] has a name and an expression</source>
        <translation>[[derived]] 须有名称和表达式</translation>
    </message>
    <message>
        <source>the recording ends at {} s, before {} s</source>
        <translation>记录在 {} s 处结束，早于 {} s</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is damaged</source>
        <translation>“{}”已损坏</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no rows</source>
        <translation>“{}”没有数据行</translation>
    </message>
    <message>
        <source>compare fewer recordings, or parts of them (halbench convert --from --to)</source>
        <translation>请比较较少的记录，或只比较其中一部分（halbench convert --from --to）</translation>
    </message>
    <message>
        <source>{}: schema: is not {}</source>
        <translation>{}：schema：不是 {}</translation>
    </message>
    <message>
        <source>make the file with &apos;halbench identify DEVICE --frequency --out&apos;</source>
        <translation>用“halbench identify DEVICE --frequency --out”生成该文件</translation>
    </message>
    <message>
        <source>{}: sample_period_s: must be more than zero</source>
        <translation>{}：sample_period_s：必须大于零</translation>
    </message>
    <message>
        <source>damaged (checksum)</source>
        <translation>已损坏（校验和）</translation>
    </message>
    <message>
        <source>cannot keep history in &apos;{}&apos;: {}</source>
        <translation>无法在“{}”中保存历史数据：{}</translation>
    </message>
    <message>
        <source>more than {} characters in a line</source>
        <translation>一行中超过 {} 个字符</translation>
    </message>
    <message>
        <source>its numbers need more than {} MB of memory</source>
        <translation>其数值需要超过 {} MB 内存</translation>
    </message>
    <message>
        <source>give --trigger SIGNAL&gt;LEVEL or SIGNAL&lt;LEVEL; now and reference belong to --capture</source>
        <translation>请给出 --trigger SIGNAL&gt;LEVEL 或 SIGNAL&lt;LEVEL；now 和 reference 属于 --capture</translation>
    </message>
    <message>
        <source>the time before the trigger must not be negative</source>
        <translation>触发前的时间不能为负</translation>
    </message>
    <message>
        <source>Give e.g. --pre-trigger 2, in seconds.</source>
        <translation>例如 --pre-trigger 2，单位为秒。</translation>
    </message>
    <message>
        <source>there is a [[derived]] named &apos;{}&apos; already</source>
        <translation>已有名为“{}”的 [[derived]]</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list of texts</source>
        <translation>“{}”必须是文本列表</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; [monitor.trigger] has on, source, mode, slope, level, hysteresis, window_s, pre_trigger_ratio, hold_off_s, board</source>
        <translation>未知的键“{}”；[monitor.trigger] 有 on、source、mode、slope、level、hysteresis、window_s、pre_trigger_ratio、hold_off_s、board</translation>
    </message>
    <message>
        <source>update Halbench, or the board&apos;s firmware</source>
        <translation>请更新 Halbench 或控制板的固件</translation>
    </message>
    <message>
        <source>the crossover or margin asked for is not a finite number</source>
        <translation>所要求的穿越频率或裕度不是有限数</translation>
    </message>
    <message>
        <source>identify the motor again, or choose a design method</source>
        <translation>重新辨识电机，或选择一种设计方法</translation>
    </message>
    <message>
        <source>the device has no axis &apos;{}&apos;</source>
        <translation>设备没有轴 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>a band of steps of this height and length is not possible</source>
        <translation>不可能有这种高度和长度的阶跃带</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a pair of [[cursors]] has name, a_s, b_s, measuring</source>
        <translation>未知的键 &apos;{}&apos;；一对 [[cursors]] 有 name、a_s、b_s、measuring</translation>
    </message>
    <message>
        <source>a pair of [[cursors]] has a name, a_s and b_s</source>
        <translation>一对 [[cursors]] 有 name、a_s 和 b_s</translation>
    </message>
    <message>
        <source>&apos;cursors&apos; must be a list of tables, [[cursors]]</source>
        <translation>&apos;cursors&apos; 必须是表的列表，[[cursors]]</translation>
    </message>
    <message>
        <source>there is a pair of [[cursors]] named &apos;{}&apos; already</source>
        <translation>已有名为 &apos;{}&apos; 的一对 [[cursors]]</translation>
    </message>
    <message>
        <source>only one pair of [[cursors]] is measuring</source>
        <translation>只有一对 [[cursors]] 可以是 measuring</translation>
    </message>
    <message>
        <source>a quoted cell does not end as it should</source>
        <translation>带引号的单元格没有正确结束</translation>
    </message>
    <message>
        <source>{} cells where there are {} before</source>
        <translation>此处有 {} 个单元格，之前有 {} 个</translation>
    </message>
    <message>
        <source>the names of several columns where there is one</source>
        <translation>只有一列，却有多列的名称</translation>
    </message>
    <message>
        <source>there are no rows of numbers</source>
        <translation>没有数字行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is written with thousands separators</source>
        <translation>“{}” 带有千位分隔符</translation>
    </message>
    <message>
        <source>{} columns are called &apos;{}&apos;</source>
        <translation>有 {} 列名为 “{}”</translation>
    </message>
    <message>
        <source>give its number: {} or {}</source>
        <translation>给出列号：{} 或 {}</translation>
    </message>
    <message>
        <source>the table has no column &apos;{}&apos;</source>
        <translation>表中没有列 “{}”</translation>
    </message>
    <message>
        <source>it has {}; a number from 1 to {} also names one</source>
        <translation>它有 {}；也可用 1 到 {} 的编号指定一列</translation>
    </message>
    <message>
        <source>for example s, ms, us, rad, deg, rad/s, rpm, A, mA, T, mT, degC, or - for none</source>
        <translation>例如 s、ms、us、rad、deg、rad/s、rpm、A、mA、T、mT、degC，- 表示无单位</translation>
    </message>
    <message>
        <source>column {}</source>
        <translation>第 {} 列</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is in {}, but {} is in {}</source>
        <translation>列 “{}” 的单位是 {}，但 {} 的单位是 {}</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>无单位</translation>
    </message>
    <message>
        <source>no header: numbers from the first line on</source>
        <translation>无表头：从第一行起就是数字</translation>
    </message>
    <message>
        <source>one line of names</source>
        <translation>一行名称</translation>
    </message>
    <message>
        <source>a line of names, then one of units</source>
        <translation>一行名称，然后一行单位</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>UTF-16 文本</translation>
    </message>
    <message>
        <source>save it as text in UTF-8</source>
        <translation>请另存为 UTF-8 文本</translation>
    </message>
    <message>
        <source>save it with line ends LF or CR LF</source>
        <translation>请以行尾 LF 或 CR LF 保存</translation>
    </message>
    <message>
        <source>{}:1:1: there are no rows</source>
        <translation>{}:1:1：没有行</translation>
    </message>
    <message>
        <source>give a file with rows of numbers</source>
        <translation>请给出含有数字行的文件</translation>
    </message>
    <message>
        <source>{}:{}:1: the line has {} characters</source>
        <translation>{}:{}:1：该行有 {} 个字符</translation>
    </message>
    <message>
        <source>the line has {} characters</source>
        <translation>该行有 {} 个字符</translation>
    </message>
    <message>
        <source>a quote inside a quoted cell is written twice</source>
        <translation>带引号的单元格内的引号要写两次</translation>
    </message>
    <message>
        <source>{} cells where the table has {} columns</source>
        <translation>此处有 {} 个单元格，而表有 {} 列</translation>
    </message>
    <message>
        <source>remove the row, or give --rate_Hz instead</source>
        <translation>删除该行，或改为给出 --rate_Hz</translation>
    </message>
    <message>
        <source>the time does not increase: {} s after {} s</source>
        <translation>时间没有递增：{} s 在 {} s 之后</translation>
    </message>
    <message>
        <source>sort the rows by time, choose another column with --time, or give --rate_Hz</source>
        <translation>按时间排序各行，用 --time 选择另一列，或给出 --rate_Hz</translation>
    </message>
    <message>
        <source>--rate_Hz: not between 1e-6 and 1e9</source>
        <translation>--rate_Hz：不在 1e-6 与 1e9 之间</translation>
    </message>
    <message>
        <source>give one of them</source>
        <translation>只给出其中一个</translation>
    </message>
    <message>
        <source>{}: {} columns</source>
        <translation>{}：{} 列</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>单位未知</translation>
    </message>
    <message>
        <source>{} rows are missing</source>
        <translation>缺少 {} 行</translation>
    </message>
    <message>
        <source>a [[plot]] with its own time axis has own_span_s, which is more than 0</source>
        <translation>有自己时间轴的 [[plot]] 有 own_span_s，且大于 0</translation>
    </message>
    <message>
        <source>give the recording another name</source>
        <translation>请为记录换一个名称</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>导入已取消</translation>
    </message>
    <message>
        <source>{}: cannot be read</source>
        <translation>{}：无法读取</translation>
    </message>
    <message>
        <source>allow at least 1.05</source>
        <translation>请至少允许 1.05</translation>
    </message>
    <message>
        <source>step {} of {}: {}</source>
        <translation>第 {} 步（共 {} 步）：{}</translation>
    </message>
    <message>
        <source>the new gains were not kept</source>
        <translation>未保留新增益</translation>
    </message>
    <message>
        <source>identify the motor again</source>
        <translation>请重新辨识电机</translation>
    </message>
    <message>
        <source>a recorded move of {} s cannot be replayed</source>
        <translation>无法重放 {} s 的记录运动</translation>
    </message>
    <message>
        <source>record {} to {} s of a move</source>
        <translation>请记录 {} 至 {} s 的运动</translation>
    </message>
    <message>
        <source>record the move again, at 100 Hz or more</source>
        <translation>请以 100 Hz 或更高速率重新记录该运动</translation>
    </message>
    <message>
        <source>the recording has no {}</source>
        <translation>记录中没有 {}</translation>
    </message>
    <message>
        <source>name mask, character {}: {}</source>
        <translation>名称模板，第 {} 个字符：{}</translation>
    </message>
    <message>
        <source>there is no placeholder &apos;{}&apos;</source>
        <translation>没有占位符“{}”</translation>
    </message>
    <message>
        <source>use letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>请使用字母、数字、“-”、“_”和“.”</translation>
    </message>
    <message>
        <source>a second {number}</source>
        <translation>第二个 {number}</translation>
    </message>
    <message>
        <source>the name mask is empty</source>
        <translation>名称模板为空</translation>
    </message>
    <message>
        <source>begin with a letter</source>
        <translation>请以字母开头</translation>
    </message>
    <message>
        <source>cannot remove &apos;{}&apos;: {}</source>
        <translation>无法移除“{}”：{}</translation>
    </message>
    <message>
        <source>--retain needs a limit</source>
        <translation>--retain 需要一个限制</translation>
    </message>
    <message>
        <source>it has tags</source>
        <translation>它有标签</translation>
    </message>
    <message>
        <source>it has notes</source>
        <translation>它有备注</translation>
    </message>
    <message>
        <source>it is open</source>
        <translation>它是打开的</translation>
    </message>
    <message>
        <source>it is write-protected</source>
        <translation>它被写保护</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>它是一个链接</translation>
    </message>
    <message>
        <source>&apos;{}&apos; of a recording is from 0 to {} s</source>
        <translation>记录的“{}”为 0 到 {} s</translation>
    </message>
    <message>
        <source>&apos;recording&apos; must be a table</source>
        <translation>“recording”必须是一个表</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; [recording] has before_s, at_trigger, after_s</source>
        <translation>未知键“{}”；[recording] 有 before_s、at_trigger、after_s</translation>
    </message>
    <message>
        <source>wait longer (--wait; wait_s of a step), or choose another trigger</source>
        <translation>等待更久（--wait；步骤的 wait_s），或选择其他触发</translation>
    </message>
    <message>
        <source>the target {} = {} is not between {} and {}</source>
        <translation>目标 {} = {} 不在 {} 与 {} 之间</translation>
    </message>
    <message>
        <source>the target step-deg needs the target current-limit-a</source>
        <translation>目标 step-deg 需要目标 current-limit-a</translation>
    </message>
    <message>
        <source>allow more current, or a smaller step</source>
        <translation>允许更大的电流，或更小的阶跃</translation>
    </message>
    <message>
        <source>any motion</source>
        <translation>任何运动</translation>
    </message>
    <message>
        <source>a name has letters, digits, &apos;.&apos; and &apos;_&apos; and begins with a letter</source>
        <translation>名称由字母、数字、“.”和“_”组成，并以字母开头</translation>
    </message>
    <message>
        <source>the name &apos;{}&apos; is given to two columns</source>
        <translation>名称“{}”被赋予两列</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is given two names</source>
        <translation>列“{}”被赋予两个名称</translation>
    </message>
    <message>
        <source>give every column one name</source>
        <translation>请给每列一个名称</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is the time and cannot be called &apos;{}&apos;</source>
        <translation>列“{}”是时间，不能称为“{}”</translation>
    </message>
    <message>
        <source>measure more cycles; calibrate the sensors first</source>
        <translation>请测量更多周期；请先标定传感器</translation>
    </message>
    <message>
        <source>identify the motor and give its model</source>
        <translation>请辨识电机并给出其模型</translation>
    </message>
    <message>
        <source>speed limit in rad/s</source>
        <translation>速度限值（rad/s）</translation>
    </message>
    <message>
        <source>number of cycles</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>the device has no parameter for {}</source>
        <translation>设备没有用于 {} 的参数</translation>
    </message>
    <message>
        <source>the relay experiment needs a position loop with a gain and a current limit</source>
        <translation>继电实验需要带增益和电流限值的位置回路</translation>
    </message>
    <message>
        <source>{}: {} was changed at {} s of the recording</source>
        <translation>{}：{} 在记录的 {} s 处被更改</translation>
    </message>
    <message>
        <source>the gains were found for the {} &apos;{}&apos;, this device is the {} &apos;{}&apos;</source>
        <translation>这些增益是为 {} “{}”求得的，而此设备是 {} “{}”</translation>
    </message>
    <message>
        <source>the gains were found for &apos;{}&apos; with other overrides than this device has</source>
        <translation>这些增益是为“{}”求得的，其覆盖参数与此设备不同</translation>
    </message>
    <message>
        <source>design them for the timing of this device</source>
        <translation>请按此设备的时序设计</translation>
    </message>
    <message>
        <source>{}; nothing was written</source>
        <translation>{}；未写入任何内容</translation>
    </message>
    <message>
        <source>[monitor] has follow and cursors (true or false), span_s, rate_hz, curves and trigger</source>
        <translation>[monitor] 有 follow 和 cursors（true 或 false）、span_s、rate_hz、curves 和 trigger</translation>
    </message>
    <message>
        <source>&apos;rate_hz&apos; must not be negative</source>
        <translation>“rate_hz”不能为负</translation>
    </message>
    <message>
        <source>must be &quot;parallel&quot;, &quot;standard&quot; or &quot;series&quot;</source>
        <translation>必须是“parallel”、“standard”或“series”</translation>
    </message>
    <message>
        <source>{}: gains.filter_s: {}</source>
        <translation>{}: gains.filter_s: {}</translation>
    </message>
    <message>
        <source>{}: gains: {}</source>
        <translation>{}: gains: {}</translation>
    </message>
    <message>
        <source>a band under a load of {} A is not possible</source>
        <translation>负载为 {} A 的范围带是不可能的</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; known are schema, device, notes, perspective, layout, monitor, monitor2, monitor3, recording, plot, cursors, derived, given, model, design, calibration</source>
        <translation>未知的键“{}”；已知的有 schema、device、notes、perspective、layout、monitor、monitor2、monitor3、recording、plot、cursors、derived、given、model、design、calibration</translation>
    </message>
    <message>
        <source>a set-point weight is not a finite number</source>
        <translation>设定值权重不是有限数</translation>
    </message>
    <message>
        <source>the set-point weight {} = {} is not between 0 and 1</source>
        <translation>设定值权重 {} = {} 不在 0 到 1 之间</translation>
    </message>
    <message>
        <source>&apos;units&apos; must be a table of signals with their units, units.position = &quot;mrad&quot;</source>
        <translation>“units”必须是由信号及其单位组成的表，如 units.position = &quot;mrad&quot;</translation>
    </message>
    <message>
        <source>&apos;units&apos; names &apos;{}&apos;, which this [[plot]] does not show</source>
        <translation>“units”中的“{}”不是这个 [[plot]] 所显示的信号</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a whole number from 1 to {}</source>
        <translation>“{}”必须是 1 到 {} 之间的整数</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[plot]] has signals, min, max, unit, right, right_min, right_max, right_unit, own_span_s, own_follow, column, height_percent, width_percent, units</source>
        <translation>未知的键“{}”；[[plot]] 有 signals、min、max、unit、right、right_min、right_max、right_unit、own_span_s、own_follow、column、height_percent、width_percent、units</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed since it was recorded: {} of {} rows</source>
        <translation>“{}”自录制以来已被更改：{} / {} 行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a device or pipe</source>
        <translation>“{}”是设备或管道</translation>
    </message>
    <message>
        <source>give a period of {} s or more</source>
        <translation>请给出 {} s 或更长的周期</translation>
    </message>
    <message>
        <source>a recorded move has rows of 1 ms and cannot be replayed through a loop of {} ms</source>
        <translation>记录的运动每行为 1 ms，无法通过 {} ms 的回路重放</translation>
    </message>
    <message>
        <source>the motor was measured at {} s with {} samples of delay, this device has {} s and {}</source>
        <translation>该电机是在 {} s、{} 个采样的时延下测量的，而此设备为 {} s 和 {}</translation>
    </message>
    <message>
        <source>turns against its current</source>
        <translation>逆着电流转动</translation>
    </message>
    <message>
        <source>current of {} A, above the limit of {} A of the recorded device</source>
        <translation>电流 {} A，高于所记录设备的限值 {} A</translation>
    </message>
    <message>
        <source>check unit and scale of the current column, e.g. current_command_mA</source>
        <translation>请检查电流列的单位和比例，例如 current_command_mA</translation>
    </message>
    <message>
        <source>current of {} A, implausible for an actuator of this kind</source>
        <translation>电流 {} A，对此类执行器不合理</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: {}</source>
        <translation>电流或角度的符号错误：{}</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs, over a wider range of speed</source>
        <translation>请在更宽的转速范围内记录更多的升速和自由减速</translation>
    </message>
    <message>
        <source>the value is zero and its interval begins there</source>
        <translation>其值为零，区间由此开始</translation>
    </message>
    <message>
        <source>check the given constants, and the units of current and angle</source>
        <translation>检查给定的常数以及电流和角度的单位</translation>
    </message>
    <message>
        <source>record the position, or rename the columns</source>
        <translation>记录位置，或重新命名各列</translation>
    </message>
    <message>
        <source>the rotor turns against its current</source>
        <translation>转子逆着电流转动</translation>
    </message>
    <message>
        <source>shorten or shield the cable, or lower the baud rate</source>
        <translation>缩短或屏蔽电缆，或降低波特率</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>请重新测量</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>请重试。</translation>
    </message>
    <message>
        <source>A number of the spherical rotor is not finite.</source>
        <translation>球形转子的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The outer radius of the magnet must be larger than the radius of its core.</source>
        <translation>磁体的外半径必须大于其铁芯的半径。</translation>
    </message>
    <message>
        <source>Relative permeabilities of the rotor are at least 1.</source>
        <translation>转子的相对磁导率至少为 1。</translation>
    </message>
    <message>
        <source>The amplitude of a spherical harmonic is not a finite number.</source>
        <translation>球谐函数的幅值不是有限数。</translation>
    </message>
    <message>
        <source>A spherical harmonic needs a degree of 1 to 16 and an order of 0 to its degree.</source>
        <translation>球谐函数的阶数须为 1 到 16，级数须为 0 到该阶数。</translation>
    </message>
    <message>
        <source>A number of the stator coil is not finite.</source>
        <translation>定子线圈的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>A stator coil needs a positive radius, turns and an axis of length one.</source>
        <translation>定子线圈需要正的半径、匝数和长度为 1 的轴向量。</translation>
    </message>
    <message>
        <source>A field sensor setting is not a finite number.</source>
        <translation>磁场传感器的一个设置不是有限数。</translation>
    </message>
    <message>
        <source>A field sensor needs positive gains, noise of at least zero and a range of at least two steps of its converter.</source>
        <translation>磁场传感器需要正的增益、不小于零的噪声，以及至少两个转换器步长的量程。</translation>
    </message>
    <message>
        <source>The pose of a field sensor is not a finite number.</source>
        <translation>磁场传感器的位姿不是有限数。</translation>
    </message>
    <message>
        <source>Place it outside the rotor&apos;s outer radius.</source>
        <translation>请将其置于转子外半径之外。</translation>
    </message>
    <message>
        <source>The three axes of a field sensor must be unit vectors that span the space.</source>
        <translation>磁场传感器的三个轴必须是张成空间的单位向量。</translation>
    </message>
    <message>
        <source>Each of the three sensors needs a place of its own.</source>
        <translation>三个传感器各需一个不同的位置。</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs at different currents, in both directions</source>
        <translation>请以不同电流在两个方向上记录更多的升速和自由减速</translation>
    </message>
    <message>
        <source>friction falls with the speed (Stribeck): at {} rad/s it is higher by {}, above about {} rad/s it is constant</source>
        <translation>摩擦随转速下降（Stribeck）：在 {} rad/s 时高出 {}，约 {} rad/s 以上为常数</translation>
    </message>
    <message>
        <source>model inadequate: the damping differs between the directions</source>
        <translation>模型不充分：两个方向的阻尼不同</translation>
    </message>
    <message>
        <source>a coefficient of a filter is not a finite number</source>
        <translation>滤波器的某个系数不是有限数</translation>
    </message>
    <message>
        <source>the filter with a1 = {}, a2 = {} is not stable</source>
        <translation>a1 = {}、a2 = {} 的滤波器不稳定</translation>
    </message>
    <message>
        <source>A number of the grid of poses is not finite.</source>
        <translation>位姿网格的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The grid of poses is empty.</source>
        <translation>位姿网格为空。</translation>
    </message>
    <message>
        <source>The grid has more than 200 million poses.</source>
        <translation>网格的位姿超过 2 亿个。</translation>
    </message>
    <message>
        <source>Make its step larger.</source>
        <translation>请增大其步长。</translation>
    </message>
    <message>
        <source>The box of the coverage proof is empty or its cells too small.</source>
        <translation>覆盖性证明的区域为空，或其单元过小。</translation>
    </message>
    <message>
        <source>The claimed placement is not on the lattice.</source>
        <translation>所声明的布置不在网格上。</translation>
    </message>
    <message>
        <source>The estimator needs harmonic passes of at least 0, at least one iteration and a positive limit of chi-square.</source>
        <translation>估计器需要球谐修正次数不小于 0、至少一次迭代，以及正的卡方限值。</translation>
    </message>
    <message>
        <source>The sensors do not determine the field of the rotor.</source>
        <translation>传感器无法确定转子的磁场。</translation>
    </message>
    <message>
        <source>Two of them need directions that differ and are not opposite.</source>
        <translation>其中两个的方向须不同，且不能相反。</translation>
    </message>
    <message>
        <source>The computation was stopped.</source>
        <translation>计算已中止。</translation>
    </message>
    <message>
        <source>A number of the rotor&apos;s motion is not finite.</source>
        <translation>转子运动的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The rotor&apos;s motion needs a positive rate, sample time and tilt of at most 180 degrees.</source>
        <translation>转子运动需要正的角速度、正的采样时间，以及不超过 180 度的正倾角。</translation>
    </message>
    <message>
        <source>The table of poses is empty.</source>
        <translation>位姿表为空。</translation>
    </message>
    <message>
        <source>the spherical motor has no parameter &apos;{}&apos;</source>
        <translation>球形电机没有参数“{}”</translation>
    </message>
    <message>
        <source>A number of the orientation sensing is not finite.</source>
        <translation>姿态测量的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The deviation of every field reading must be positive.</source>
        <translation>每个磁场读数的偏差必须为正。</translation>
    </message>
    <message>
        <source>The strength q of the rotor&apos;s field must be positive.</source>
        <translation>转子磁场的强度 q 必须为正。</translation>
    </message>
    <message>
        <source>The reference radius of the rotor&apos;s field must be positive.</source>
        <translation>转子磁场的参考半径必须为正。</translation>
    </message>
    <message>
        <source>The estimators need harmonics of even degree and even order.</source>
        <translation>估计器需要阶数和级数均为偶数的球谐函数。</translation>
    </message>
    <message>
        <source>Others break the symmetry of the four-pole rotor.</source>
        <translation>其他球谐函数会破坏四极转子的对称性。</translation>
    </message>
    <message>
        <source>A setting of the particle swarm is not a finite number.</source>
        <translation>粒子群的一个设置不是有限数。</translation>
    </message>
    <message>
        <source>The box of the particle swarm is empty.</source>
        <translation>粒子群的搜索区域为空。</translation>
    </message>
    <message>
        <source>The particle swarm needs 1 to 128 particles and numbers of steps of at least 0.</source>
        <translation>粒子群需要 1 到 128 个粒子，且步数不小于 0。</translation>
    </message>
    <message>
        <source>Thresholds, pulls and stops of the particle swarm are at least zero, its limits of velocity and step positive.</source>
        <translation>粒子群的阈值、牵引系数和停止值不小于零，其速度和步长限值为正。</translation>
    </message>
    <message>
        <source>set-point weight b</source>
        <translation>设定值权重 b</translation>
    </message>
    <message>
        <source>set-point weight c</source>
        <translation>设定值权重 c</translation>
    </message>
    <message>
        <source>filters in series</source>
        <translation>串联滤波器</translation>
    </message>
    <message>
        <source>more than {} filters in series</source>
        <translation>多于 {} 个的串联滤波器</translation>
    </message>
    <message>
        <source>, no </source>
        <translation>、</translation>
    </message>
    <message>
        <source>The closed form of the additive model needs sensor 1 at (0, 0, 45 degrees).</source>
        <translation>相加模型的闭式解要求传感器 1 位于 (0, 0, 45 度)。</translation>
    </message>
    <message>
        <source>a bandwidth of {} Hz is not possible on this axis at {} Hz sampling and {} samples of delay</source>
        <translation>在 {1} Hz 采样和 {2} 个采样的延迟下，此轴无法达到 {0} Hz 的带宽</translation>
    </message>
    <message>
        <source>axis {}: {}</source>
        <translation>轴 {}：{}</translation>
    </message>
    <message>
        <source>{} is in &quot;{}&quot;, not in &quot;{}&quot;</source>
        <translation>{} 的单位是“{}”，而不是“{}”</translation>
    </message>
    <message>
        <source>identify the axis again</source>
        <translation>请重新辨识该轴</translation>
    </message>
    <message>
        <source>{} = {} must {}</source>
        <translation>{} = {} 必须{}</translation>
    </message>
    <message>
        <source>not be negative</source>
        <translation>不为负</translation>
    </message>
    <message>
        <source>be positive</source>
        <translation>为正</translation>
    </message>
    <message>
        <source>an axis of the model has no name</source>
        <translation>模型中有一个轴没有名称</translation>
    </message>
    <message>
        <source>name every axis</source>
        <translation>请为每个轴命名</translation>
    </message>
    <message>
        <source>use rad or m</source>
        <translation>请使用 rad 或 m</translation>
    </message>
    <message>
        <source>damping rate</source>
        <translation>阻尼率</translation>
    </message>
    <message>
        <source>acceleration gain</source>
        <translation>加速度增益</translation>
    </message>
    <message>
        <source>axis {}</source>
        <translation>轴 {}</translation>
    </message>
    <message>
        <source>{}: damping rate</source>
        <translation>{}：阻尼率</translation>
    </message>
    <message>
        <source>{}: acceleration gain</source>
        <translation>{}：加速度增益</translation>
    </message>
    <message>
        <source>{}: breakaway effort</source>
        <translation>{}：起动作用量</translation>
    </message>
    <message>
        <source>name AXIS.damping_rate, AXIS.acceleration_gain, AXIS.breakaway_effort</source>
        <translation>请使用 AXIS.damping_rate、AXIS.acceleration_gain、AXIS.breakaway_effort</translation>
    </message>
    <message>
        <source>the covariance needs as many rows and columns of finite numbers as names</source>
        <translation>协方差的行数和列数必须与名称数相同，且均为有限数</translation>
    </message>
    <message>
        <source>identify the axes again</source>
        <translation>请重新辨识各轴</translation>
    </message>
    <message>
        <source>the model has no axis</source>
        <translation>模型没有轴</translation>
    </message>
    <message>
        <source>{}, or use method recommended</source>
        <translation>{}，或使用方法 recommended</translation>
    </message>
    <message>
        <source>with friction and the effort limit of {} {} a step of {} overshoots by {} %</source>
        <translation>在摩擦和 {} {} 的作用量限制下，{} 的阶跃超调 {} %</translation>
    </message>
    <message>
        <source>friction holds the axis within {} of the reference</source>
        <translation>摩擦使该轴停在距参考值 {} 以内</translation>
    </message>
    <message>
        <source>identify the axis to get its uncertainty</source>
        <translation>请辨识该轴以获得其不确定度</translation>
    </message>
    <message>
        <source>the model has no axis &apos;{}&apos;</source>
        <translation>模型没有轴 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>Half-angle of the cone that holds the shaft with 95 %</source>
        <translation>以 95 % 概率包含转轴的锥的半角</translation>
    </message>
    <message>
        <source>the excited rows are not whole periods of all signals</source>
        <translation>激励的数据行不是所有信号的整数个周期</translation>
    </message>
    <message>
        <source>there is no excited row of any axis</source>
        <translation>没有任何轴的激励数据行</translation>
    </message>
    <message>
        <source>{} experiments do not decide {} inputs</source>
        <translation>{} 次实验不能确定 {} 个输入</translation>
    </message>
    <message>
        <source>measure as many as there are inputs</source>
        <translation>实验次数应与输入个数相同</translation>
    </message>
    <message>
        <source>the experiments do not have the same axes</source>
        <translation>各次实验的轴不相同</translation>
    </message>
    <message>
        <source>the excitation did not reach every axis at {} Hz</source>
        <translation>在 {} Hz 处激励没有到达每个轴</translation>
    </message>
    <message>
        <source>check that the excitation ran on all of them</source>
        <translation>检查激励是否在所有轴上运行</translation>
    </message>
    <message>
        <source>tries the excitation</source>
        <translation>试探激励</translation>
    </message>
    <message>
        <source>excites from {} to {} Hz, {} of {}</source>
        <translation>在 {} 至 {} Hz 激励，第 {} 次，共 {} 次</translation>
    </message>
    <message>
        <source>the board cannot add an excitation to the command of axis {}</source>
        <translation>控制板不能在轴 {} 的指令上叠加激励</translation>
    </message>
    <message>
        <source>it needs a parameter &apos;{}&apos; and a signal of the command</source>
        <translation>它需要参数 &apos;{}&apos; 和指令信号</translation>
    </message>
    <message>
        <source>the effort that axis {} has at its limit is not known</source>
        <translation>轴 {} 在限值处的作用量未知</translation>
    </message>
    <message>
        <source>add effort_limit to the axis in the profile of the device</source>
        <translation>在设备描述文件的该轴中加入 effort_limit</translation>
    </message>
    <message>
        <source>the recording lacks the signal &apos;{}&apos;</source>
        <translation>记录中缺少信号 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the device must send position and command of every axis</source>
        <translation>设备必须发送每个轴的位置和指令</translation>
    </message>
    <message>
        <source>rows are missing in the band from {} Hz: the periods do not fit together</source>
        <translation>从 {} Hz 起的频段缺少数据行：各周期无法对齐</translation>
    </message>
    <message>
        <source>axis {}: no phase margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>轴 {}：无相位裕度：回路在所用频率上没有穿越</translation>
    </message>
    <message>
        <source>axis {}: no phase margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>轴 {}：无相位裕度：穿越处的频率被剔除或间隔过大</translation>
    </message>
    <message>
        <source>axis {}: no phase margin: its interval is {} deg to either side</source>
        <translation>轴 {}：无相位裕度：其区间为两侧各 {} 度</translation>
    </message>
    <message>
        <source>{} deg are allowed: measure more periods or with more effort</source>
        <translation>允许 {} 度：测量更多周期或加大作用量</translation>
    </message>
    <message>
        <source>axis {}: no gain margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>轴 {}：无幅值裕度：回路在所用频率上没有穿越</translation>
    </message>
    <message>
        <source>axis {}: no gain margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>轴 {}：无幅值裕度：穿越处的频率被剔除或间隔过大</translation>
    </message>
    <message>
        <source>axis {}: no gain margin: its interval is {} dB to either side</source>
        <translation>轴 {}：无幅值裕度：其区间为两侧各 {} dB</translation>
    </message>
    <message>
        <source>{} dB are allowed: measure more periods or with more effort</source>
        <translation>允许 {} dB：测量更多周期或加大作用量</translation>
    </message>
    <message>
        <source>measure with more periods or more effort there</source>
        <translation>在该处用更多周期或更大作用量测量</translation>
    </message>
    <message>
        <source>axis {}: {} of {} frequencies have a coherence below {} and were left out</source>
        <translation>轴 {}：{} 个（共 {} 个）频率的相干性低于 {}，已剔除</translation>
    </message>
    <message>
        <source>measure more periods or with more effort</source>
        <translation>测量更多周期或加大作用量</translation>
    </message>
    <message>
        <source>no peak of the sensitivity: it is largest at the end of the frequencies that are used</source>
        <translation>无灵敏度峰值：最大值位于所用频率的端点</translation>
    </message>
    <message>
        <source>no peak of the sensitivity: at no frequency all axes are coherent</source>
        <translation>无灵敏度峰值：没有一个频率上所有轴都相干</translation>
    </message>
    <message>
        <source>no peak of the complementary sensitivity: it is largest at the end of the frequencies that are used</source>
        <translation>无补灵敏度峰值：最大值位于所用频率的端点</translation>
    </message>
    <message>
        <source>no peak of the complementary sensitivity: at no frequency all axes are coherent</source>
        <translation>无补灵敏度峰值：没有一个频率上所有轴都相干</translation>
    </message>
    <message>
        <source>in {} % of the samples the currents were at their limit: the command did not flow as told</source>
        <translation>{} % 的采样中电流达到限值：指令未按所示输出</translation>
    </message>
    <message>
        <source>measure with less effort</source>
        <translation>减小作用量再测量</translation>
    </message>
    <message>
        <source>lowest frequency (Hz)</source>
        <translation>最低频率（Hz）</translation>
    </message>
    <message>
        <source>highest frequency (Hz)</source>
        <translation>最高频率（Hz）</translation>
    </message>
    <message>
        <source>{} to {} Hz is less than an octave</source>
        <translation>{} 至 {} Hz 不足一个倍频程</translation>
    </message>
    <message>
        <source>widen the band: margins need neighbours on both sides</source>
        <translation>加宽频段：裕度需要两侧的相邻点</translation>
    </message>
    <message>
        <source>effort of each axis over its limit</source>
        <translation>各轴作用量与其限值之比</translation>
    </message>
    <message>
        <source>from {} to {} Hz there is no room for two lines of each axis</source>
        <translation>{} 至 {} Hz 之间容不下每轴两条谱线</translation>
    </message>
    <message>
        <source>measure from a lower or to a higher frequency</source>
        <translation>从更低频率开始或测量到更高频率</translation>
    </message>
    <message>
        <source>the board went on without one of its sensors: the position changed its noise and its errors meanwhile</source>
        <translation>控制板在缺少一个传感器的情况下继续运行：其间位置的噪声和误差发生了变化</translation>
    </message>
    <message>
        <source>check the sensors and their cables, and measure again</source>
        <translation>检查传感器及其电缆，然后重新测量</translation>
    </message>
    <message>
        <source>correct the line or open an earlier copy; the help shows the form of the files</source>
        <translation>更正该行，或打开较早的副本；帮助中说明了文件格式</translation>
    </message>
    <message>
        <source>the sensors of this device need no calibration</source>
        <translation>此设备的传感器不需要标定</translation>
    </message>
    <message>
        <source>use identify or record</source>
        <translation>请使用辨识或记录</translation>
    </message>
    <message>
        <source>force per effort</source>
        <translation>单位作用量的力</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{}：{}</translation>
    </message>
    <message>
        <source>The motion does not excite the axis enough: check that nothing holds it.</source>
        <translation>运动对该轴的激励不足：请检查是否有东西卡住它。</translation>
    </message>
    <message>
        <source>axis {}: damping, friction and effort leave {} % of the acceleration unexplained</source>
        <translation>轴 {}：阻尼、摩擦和作用量未能解释加速度的 {} %</translation>
    </message>
    <message>
        <source>The axis has a force that depends on the position, or another axis acts on it.</source>
        <translation>该轴上有随位置变化的力，或受到另一个轴的作用。</translation>
    </message>
    <message>
        <source>Design with the upper bound, or identify again with a wider window.</source>
        <translation>请按上限设计，或放宽窗口后重新辨识。</translation>
    </message>
    <message>
        <source>Nothing to do where the axis has none.</source>
        <translation>如果该轴没有摩擦，则无需处理。</translation>
    </message>
    <message>
        <source>axis {}: {} of {} windows of the motion miss rows</source>
        <translation>轴 {}：{} 个运动窗口（共 {} 个）缺少行</translation>
    </message>
    <message>
        <source>only ratios follow from the motion: damping, friction and force have no absolute value</source>
        <translation>由运动只能得到比值：阻尼、摩擦和力没有绝对值</translation>
    </message>
    <message>
        <source>Weigh a slide and give its mass: --given m=0.2, in an experiment given = { m = 0.2 }.</source>
        <translation>请称量滑块并给出其质量：--given m=0.2，在实验文件中 given = { m = 0.2 }。</translation>
    </message>
    <message>
        <source>this device has no constant &apos;{}&apos;</source>
        <translation>此设备没有常数 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>known is m (moving mass of an axis, kg)</source>
        <translation>已知的是 m（轴的运动质量，kg）</translation>
    </message>
    <message>
        <source>leave them out; this device takes an axis and a given m</source>
        <translation>请省略；此设备接受轴和给定的 m</translation>
    </message>
    <message>
        <source>Check that nothing holds the axis, and that it follows its reference.</source>
        <translation>请检查没有东西卡住该轴，并且它跟随其参考值。</translation>
    </message>
    <message>
        <source>only {} of {} stretches of {} s in steady motion</source>
        <translation>只有 {} 段（需要 {} 段，每段 {} s）处于稳定运动</translation>
    </message>
    <message>
        <source>the axis moved one way only</source>
        <translation>该轴只向一侧运动</translation>
    </message>
    <message>
        <source>the effort shows no effect on the motion within 8 rows</source>
        <translation>作用量在 8 行之内对运动没有影响</translation>
    </message>
    <message>
        <source>the delay of the effort is not decided by the motion</source>
        <translation>由运动无法确定作用量的延迟</translation>
    </message>
    <message>
        <source>runs with a sine on its speed</source>
        <translation>以叠加正弦的速度扫过</translation>
    </message>
    <message>
        <source>goes to its place</source>
        <translation>移动到位</translation>
    </message>
    <message>
        <source>axis {} {}</source>
        <translation>轴 {} {}</translation>
    </message>
    <message>
        <source>the device lacks position or effort of axis {}</source>
        <translation>设备缺少轴 {} 的位置或作用量</translation>
    </message>
    <message>
        <source>Its profile needs both roles.</source>
        <translation>其配置文件需要这两个角色。</translation>
    </message>
    <message>
        <source>axis {}: damping changes with the speed, the intervals do not include it</source>
        <translation>轴 {}：阻尼随速度变化，区间未包含此影响</translation>
    </message>
    <message>
        <source>Use the values near the speeds of the motion only; look for drag, or friction that grows with the speed.</source>
        <translation>仅在接近该运动速度时使用这些值；请查找流体阻力或随速度增大的摩擦。</translation>
    </message>
    <message>
        <source>axis {}: negative friction, not possible</source>
        <translation>轴 {}：摩擦为负，不可能</translation>
    </message>
    <message>
        <source>axis {}: negative damping, not possible</source>
        <translation>轴 {}：阻尼为负，不可能</translation>
    </message>
    <message>
        <source>The axis has a force that the model lacks, or position and effort are shifted in time.</source>
        <translation>该轴受到模型中没有的力，或位置与控制量在时间上错位。</translation>
    </message>
    <message>
        <source>Nothing was changed. Take the load of cable or tilt off the platen, clear the stop, move the platen to the middle, and start again.</source>
        <translation>未作任何更改。请消除电缆或倾斜对动子的作用力，解除停止，将动子移到中央，然后重新开始。</translation>
    </message>
    <message>
        <source>the gains are for a device &apos;{}&apos;, the model is of a &apos;{}&apos;</source>
        <translation>增益属于设备“{}”，模型属于“{}”</translation>
    </message>
    <message>
        <source>open gains that were found with a model of this kind of device</source>
        <translation>请打开用同类设备的模型得到的增益</translation>
    </message>
    <message>
        <source>the gains are for axes {}, the model has {}</source>
        <translation>增益对应的轴为 {}，模型的轴为 {}</translation>
    </message>
    <message>
        <source>open gains for an axis of the model</source>
        <translation>请打开模型所含轴的增益</translation>
    </message>
    <message>
        <source>a path does not alternate its direction</source>
        <translation>路径不交替方向</translation>
    </message>
    <message>
        <source>repeat it as it is: it ends where its last line ends</source>
        <translation>请按原样重复：它在最后一行的终点结束</translation>
    </message>
    <message>
        <source>{} and {} are the same value</source>
        <translation>{} 和 {} 是同一个值</translation>
    </message>
    <message>
        <source>Give one of them.</source>
        <translation>只给出其中一个。</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not in {}</source>
        <translation>“{}”的单位不是 {}</translation>
    </message>
    <message>
        <source>give the unit of its numbers, e.g. {}: halbench import --unit COLUMN=UNIT --map {}=COLUMN</source>
        <translation>请给出数值的单位，例如 {}：halbench import --unit COLUMN=UNIT --map {}=COLUMN</translation>
    </message>
    <message>
        <source>there are {}</source>
        <translation>现有 {}</translation>
    </message>
    <message>
        <source>sensor {} gave no reading in the whole record</source>
        <translation>传感器 {} 在整个记录中没有读数</translation>
    </message>
    <message>
        <source>Connect it, or check channels.off and its range: the calibration needs all three sensors.</source>
        <translation>请连接它，或检查 channels.off 及其量程：标定需要全部三个传感器。</translation>
    </message>
    <message>
        <source>{} gave no reading: its gain and offset keep their values</source>
        <translation>{} 没有读数：其增益和偏移保持原值</translation>
    </message>
    <message>
        <source>Leave it out with channels.off, or repair it and calibrate again.</source>
        <translation>用 channels.off 将其排除，或修复后重新标定。</translation>
    </message>
    <message>
        <source>The common sign of all readings is not observable without a known orientation: reversed, they are those of a rotor that is spun by 90 degrees.</source>
        <translation>没有已知姿态时，所有读数的共同符号不可观测：反号后等同于转子自旋 90 度。</translation>
    </message>
    <message>
        <source>Compare one orientation with the rotor, or record reference.alpha, .beta and .gamma.</source>
        <translation>请将一个姿态与转子比对，或记录 reference.alpha、.beta 和 .gamma。</translation>
    </message>
    <message>
        <source>: sensor {} is missing</source>
        <translation>：缺少传感器 {}</translation>
    </message>
    <message>
        <source>A calibration needs nine fields, field.0.r, field.0.theta ... field.2.phi; record all sensors, or rename columns with halbench import --map. There are {}.</source>
        <translation>标定需要九个场分量 field.0.r、field.0.theta ... field.2.phi；请记录所有传感器，或用 halbench import --map 重命名列。现有 {}。</translation>
    </message>
    <message>
        <source>the known orientation at {} s is beyond one turn, {} rad: it is in degrees</source>
        <translation>{} s 处的已知姿态超过一整圈，{} rad：其单位是度</translation>
    </message>
    <message>
        <source>Give the unit of its columns: halbench import --unit COLUMN=deg.</source>
        <translation>请给出这些列的单位：halbench import --unit COLUMN=deg。</translation>
    </message>
    <message>
        <source>Check the wiring and the direction of the sensors, reverse the sign of these columns and calibrate again.</source>
        <translation>检查传感器的接线和方向，将这些列反号后重新标定。</translation>
    </message>
    <message>
        <source>{} read with the opposite sign of the others</source>
        <translation>{} 的符号与其他读数相反</translation>
    </message>
    <message>
        <source>the known orientations differ from those of the readings by {} degrees (median)</source>
        <translation>已知姿态与读数得出的姿态相差 {} 度（中位数）</translation>
    </message>
    <message>
        <source>Check their unit, the order of the rotations (Z, then Y, then X of the stator), their time base and the placement of the sensors.</source>
        <translation>检查其单位、旋转顺序（定子的 Z、Y、X）、时间基准以及传感器的位置。</translation>
    </message>
    <message>
        <source>all readings have the opposite sign of those that {}.alpha, .beta and .gamma tell: their sign, or that of q, is reversed</source>
        <translation>所有读数与 {}.alpha、.beta、.gamma 所对应的符号相反：读数或 q 的符号反了</translation>
    </message>
    <message>
        <source>Sensor {} lies inside the rotor: {} mm from its centre, the rotor has {} mm.</source>
        <translation>传感器 {} 位于转子内：距其中心 {} mm，转子半径为 {} mm。</translation>
    </message>
    <message>
        <source>Sensors {} and {} lie at the same place.</source>
        <translation>传感器 {} 和 {} 位于同一位置。</translation>
    </message>
    <message>
        <source>{}: {}: needs axis, position_unit and effort_unit</source>
        <translation>{}：{}：需要 axis、position_unit 和 effort_unit</translation>
    </message>
    <message>
        <source>{}: {}: gains: needs kp, ki, kd and filter_s</source>
        <translation>{}：{}：gains：需要 kp、ki、kd 和 filter_s</translation>
    </message>
    <message>
        <source>{}: sample_period_s, delay_samples: must be numbers, the first above zero</source>
        <translation>{}：sample_period_s、delay_samples：必须是数值，且前者大于零</translation>
    </message>
    <message>
        <source>{}: axes: the list is empty</source>
        <translation>{}：axes：列表为空</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs a frequency above the previous one and below half the rate</source>
        <translation>{}：points[{}]：频率须大于前一点并小于速率的一半</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs loops, used and coherence of each axis</source>
        <translation>{}：points[{}]：需要每个轴的 loops、used 和 coherence</translation>
    </message>
    <message>
        <source>measure the response of a device with several axes</source>
        <translation>请测量多轴设备的频率响应</translation>
    </message>
    <message>
        <source>axis {}: the response is in {}/({}), the model in {}/({})</source>
        <translation>轴 {}：响应的单位为 {}/({})，模型的单位为 {}/({})</translation>
    </message>
    <message>
        <source>measure the response on this kind of device</source>
        <translation>请在此类设备上测量响应</translation>
    </message>
    <message>
        <source>the response is of axes {}, the model has {}</source>
        <translation>响应对应的轴为 {}，模型的轴为 {}</translation>
    </message>
    <message>
        <source>open the response of an axis of the model</source>
        <translation>请打开模型所含轴的响应</translation>
    </message>
    <message>
        <source>no axes were identified</source>
        <translation>尚未辨识任何轴</translation>
    </message>
    <message>
        <source>identify the axes first</source>
        <translation>请先辨识各轴</translation>
    </message>
    <message>
        <source>the response is of a device &apos;{}&apos;, the model is of a &apos;{}&apos;</source>
        <translation>响应来自设备“{}”，模型来自“{}”</translation>
    </message>
    <message>
        <source>open a response of this kind of device</source>
        <translation>请打开此类设备的响应</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number ({})</source>
        <translation>&apos;{}&apos; 不是数（{}）</translation>
    </message>
    <message>
        <source>write a number, or leave the cell empty where a value is missing; remove a column of words; or set the format with --separator, --decimal and --header</source>
        <translation>请填写数，缺少值时将单元格留空；删除文字列；或用 --separator、--decimal 和 --header 设置格式</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number (column {}, &apos;{}&apos;)</source>
        <translation>&apos;{}&apos; 不是数（第 {} 列，&apos;{}&apos;）</translation>
    </message>
    <message>
        <source>write numbers like -1{}5e-3, leave the cell empty where a value is missing, or set --decimal</source>
        <translation>请按 -1{}5e-3 的形式写数，缺少值时将单元格留空，或设置 --decimal</translation>
    </message>
    <message>
        <source>the time is missing (column {}, &apos;{}&apos;)</source>
        <translation>缺少时间（第 {} 列，&apos;{}&apos;）</translation>
    </message>
    <message>
        <source>line {}, column {}, &apos;{}&apos;</source>
        <translation>第 {} 行第 {} 列，&apos;{}&apos;</translation>
    </message>
    <message>
        <source>is {}, must be a whole number not below {}</source>
        <translation>为 {}，必须是不小于 {} 的整数</translation>
    </message>
    <message>
        <source>is {}, must be a whole number from {} to {}</source>
        <translation>为 {}，必须是 {} 到 {} 的整数</translation>
    </message>
    <message>
        <source>is {}, must be from {} to {}</source>
        <translation>为 {}，必须在 {} 到 {} 之间</translation>
    </message>
    <message>
        <source>is {}, must be above {}</source>
        <translation>为 {}，必须大于 {}</translation>
    </message>
    <message>
        <source>is {}, must not be below {}</source>
        <translation>为 {}，不得小于 {}</translation>
    </message>
    <message>
        <source>correct the value or write the file again</source>
        <translation>请更正该值或重新写出文件</translation>
    </message>
    <message>
        <source>is {}, no variance is negative</source>
        <translation>为 {}，方差不会为负</translation>
    </message>
    <message>
        <source>is {} and [{}][{}] {}: must be equal</source>
        <translation>为 {}，而 [{}][{}] 为 {}：必须相等</translation>
    </message>
    <message>
        <source>is {}, a correlation beyond 1: at most {}</source>
        <translation>为 {}，相关系数超过 1：至多 {}</translation>
    </message>
    <message>
        <source>cells without a number: {}, the first in {}</source>
        <translation>没有数的单元格：{}，第一个在{}</translation>
    </message>
    <message>
        <source>they are missing values of the recording; enter them in the table where they are known</source>
        <translation>它们是记录中的缺失值；已知时请填入表格</translation>
    </message>
    <message>
        <source>is {}, must be below {}, half of the sampling rate</source>
        <translation>为 {}，必须小于采样率的一半 {}</translation>
    </message>
    <message>
        <source>{} has no value at {} s (row {}, {} such rows)</source>
        <translation>{} 在 {} s 处没有值（第 {} 行数据，共 {} 行如此）</translation>
    </message>
    <message>
        <source>remove these rows (the first is line {} of a CSV file) or enter their values</source>
        <translation>请删除这些行（第一行是 CSV 文件的第 {} 行）或填入其值</translation>
    </message>
    <message>
        <source>the gains are for a sampling period of {} s, this device has {} s</source>
        <translation>这些增益用于 {} s 的采样周期，此设备为 {} s</translation>
    </message>
    <message>
        <source>turns straight</source>
        <translation>转正</translation>
    </message>
    <message>
        <source>measure the frequency response of its axes instead (identify --frequency)</source>
        <translation>请改为测量其各轴的频率响应（identify --frequency）</translation>
    </message>
    <message>
        <source>use fewer signals or a lower rate; with udp:, connect by tcp: instead</source>
        <translation>请减少信号或降低速率；若用 udp: 连接，请改用 tcp:</translation>
    </message>
    <message>
        <source>compare the current that flows with the commanded one, since a gain error of the drive contradicts so; then give only the best-known constant</source>
        <translation>请将实际电流与命令电流比较，因为驱动的增益误差会造成这种矛盾；然后只给出最可靠的常数</translation>
    </message>
    <message>
        <source>a sweep of currents, directions, current tolerance or added inertia are for a motor</source>
        <translation>电流扫描、方向、电流容差或附加惯量仅适用于电机</translation>
    </message>
    <message>
        <source>the current is taken as commanded within 0.3 %: a gain error of the drive moves phi, or J, c and K_f where phi is given, by as much and shows in no recording</source>
        <translation>电流按命令值计，误差在 0.3 % 之内：驱动的增益误差使 phi（给定 phi 时为 J、c 和 K_f）偏移同样多，且不会显现在任何记录中</translation>
    </message>
    <message>
        <source>the current is taken as commanded within {} %, as stated: the intervals include a gain error of the drive up to that; a larger one shows in no recording</source>
        <translation>电流按所给出的容差计为命令值，误差在 {} % 之内：区间包含不超过它的驱动增益误差；更大的误差不会显现在任何记录中</translation>
    </message>
    <message>
        <source>state how well the current is known (--current-tolerance-percent), compare the current that flows with the commanded one, or give both J and phi: the program then finds a contradiction</source>
        <translation>请说明对电流的了解程度（--current-tolerance-percent），将实际电流与命令电流比较，或同时给出 J 和 phi：程序随后会发现矛盾</translation>
    </message>
    <message>
        <source>the current tolerance is not a finite number</source>
        <translation>电流容差不是有限数</translation>
    </message>
    <message>
        <source>give it in per cent, e.g. 3</source>
        <translation>请以百分数给出，例如 3</translation>
    </message>
    <message>
        <source>a current tolerance of {} % is not possible</source>
        <translation>电流容差 {} % 不可能</translation>
    </message>
    <message>
        <source>give 0 to 50 %</source>
        <translation>请给出 0 到 50 %</translation>
    </message>
    <message>
        <source>the rotor came near standstill: measured with {} of the planned amplitude</source>
        <translation>转子接近静止：以计划幅值的 {} 倍测量</translation>
    </message>
    <message>
        <source>choose a higher base speed for a larger amplitude</source>
        <translation>如需更大的幅值，请选择更高的基础转速</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Of the circle, whose centre lies so far in the direction of x, or of the arc</source>
        <translation>圆（圆心沿 x 方向相距此值）或圆弧的半径</translation>
    </message>
    <message>
        <source>Of the arc, counter-clockwise</source>
        <translation>圆弧的角度，逆时针为正</translation>
    </message>
    <message>
        <source>Direction in which arc and line begin, from x towards y</source>
        <translation>圆弧和直线的起始方向，从 x 转向 y</translation>
    </message>
    <message>
        <source>Of the line</source>
        <translation>直线的长度</translation>
    </message>
    <message>
        <source>the heading of a path is not a number</source>
        <translation>路径的起始方向不是数字</translation>
    </message>
    <message>
        <source>Give a finite angle.</source>
        <translation>请给出有限的角度。</translation>
    </message>
    <message>
        <source>noise and drawn errors of this specimen</source>
        <translation>本样机的噪声和随机误差</translation>
    </message>
    <message>
        <source>noise, sensor errors and spread</source>
        <translation>噪声、传感器误差和离散性</translation>
    </message>
    <message>
        <source>converters and amplifiers, or exact values</source>
        <translation>转换器和放大器，或精确值</translation>
    </message>
    <message>
        <source>motion: CSV file of poses</source>
        <translation>运动：位姿 CSV 文件</translation>
    </message>
    <message>
        <source>rotor inertia</source>
        <translation>转子转动惯量</translation>
    </message>
    <message>
        <source>torque per ampere of current amplitude</source>
        <translation>每安培电流幅值的转矩</translation>
    </message>
    <message>
        <source>current amplitude limit</source>
        <translation>电流幅值限值</translation>
    </message>
    <message>
        <source>field amplitude at the Hall sensors</source>
        <translation>霍尔传感器处的磁场幅值</translation>
    </message>
    <message>
        <source>resistance of one phase</source>
        <translation>单相电阻</translation>
    </message>
    <message>
        <source>inductance of one phase</source>
        <translation>单相电感</translation>
    </message>
    <message>
        <source>rotor angle at the start</source>
        <translation>起始转子角度</translation>
    </message>
    <message>
        <source>amplifier resistor R{}</source>
        <translation>放大器电阻 R{}</translation>
    </message>
    <message>
        <source>amplifier current shunt</source>
        <translation>放大器电流分流电阻</translation>
    </message>
    <message>
        <source>amplifier capacitor C{}</source>
        <translation>放大器电容 C{}</translation>
    </message>
    <message>
        <source>Hall sensitivity at 25 degC</source>
        <translation>25 °C 时的霍尔灵敏度</translation>
    </message>
    <message>
        <source>temperature coefficient of the Hall sensitivity</source>
        <translation>霍尔灵敏度的温度系数</translation>
    </message>
    <message>
        <source>Hall output at zero field</source>
        <translation>零磁场时的霍尔输出</translation>
    </message>
    <message>
        <source>field of a phase at its own sensor</source>
        <translation>相电流在自身传感器处的磁场</translation>
    </message>
    <message>
        <source>computation delay of the position loop</source>
        <translation>位置环的计算延迟</translation>
    </message>
    <message>
        <source>relative run-to-run friction scatter, 1 sigma</source>
        <translation>各次运行间摩擦的相对离散，1 sigma</translation>
    </message>
    <message>
        <source>relative once-per-turn friction, amplitude</source>
        <translation>每转一次的相对摩擦，幅值</translation>
    </message>
    <message>
        <source>static over kinetic friction</source>
        <translation>静摩擦与动摩擦之比</translation>
    </message>
    <message>
        <source>speed at which static friction fades</source>
        <translation>静摩擦消退的速度</translation>
    </message>
    <message>
        <source>Hall noise per sample, rms</source>
        <translation>每次采样的霍尔噪声，有效值</translation>
    </message>
    <message>
        <source>zero offset of both sensors; drawn for each if not given</source>
        <translation>两个传感器的零偏；未给出时各自随机抽取</translation>
    </message>
    <message>
        <source>spread of the drawn offsets, 1 sigma</source>
        <translation>随机零偏的离散，1 sigma</translation>
    </message>
    <message>
        <source>gain of sensor a over sensor b, minus one; drawn for each if not given</source>
        <translation>传感器 a 与 b 的增益之比减一；未给出时各自随机抽取</translation>
    </message>
    <message>
        <source>spread of the drawn gains, 1 sigma</source>
        <translation>随机增益的离散，1 sigma</translation>
    </message>
    <message>
        <source>spread of the drawn linearity errors</source>
        <translation>随机线性误差的离散</translation>
    </message>
    <message>
        <source>angle error between the sensors; drawn if not given</source>
        <translation>传感器间的角度误差；未给出时随机抽取</translation>
    </message>
    <message>
        <source>spread of the drawn angle error</source>
        <translation>随机角度误差的离散</translation>
    </message>
    <message>
        <source>spread of the sensors&apos; radius</source>
        <translation>传感器半径的离散</translation>
    </message>
    <message>
        <source>remanence scatter of the bars, 1 sigma; their angle scatter goes with it (0.02: 1 deg)</source>
        <translation>磁条剩磁离散，1 sigma；其角度离散随之变化（0.02：1 度）</translation>
    </message>
    <message>
        <source>temperature coefficient of field and torque</source>
        <translation>磁场和转矩的温度系数</translation>
    </message>
    <message>
        <source>ambient temperature</source>
        <translation>环境温度</translation>
    </message>
    <message>
        <source>share of the coil&apos;s rise at its sensor</source>
        <translation>传感器随线圈温升的比例</translation>
    </message>
    <message>
        <source>error of both temperature sensors; drawn for each if not given</source>
        <translation>两个温度传感器的误差；未给出时各自随机抽取</translation>
    </message>
    <message>
        <source>spread of the drawn temperature errors</source>
        <translation>随机温度误差的离散</translation>
    </message>
    <message>
        <source>heat capacity of one phase</source>
        <translation>单相热容</translation>
    </message>
    <message>
        <source>from one phase to ambient</source>
        <translation>单相到环境</translation>
    </message>
    <message>
        <source>temperature coefficient of the resistance</source>
        <translation>电阻温度系数</translation>
    </message>
    <message>
        <source>thermal seconds per second; 0: no heating</source>
        <translation>每秒对应的热秒数；0：不发热</translation>
    </message>
    <message>
        <source>gain error of both outputs; drawn if not given</source>
        <translation>两个输出的增益误差；未给出时随机抽取</translation>
    </message>
    <message>
        <source>spread of the drawn gain errors, 1 sigma</source>
        <translation>随机增益误差的离散，1 sigma</translation>
    </message>
    <message>
        <source>integral non-linearity of both outputs; drawn if not given</source>
        <translation>两个输出的积分非线性；未给出时随机抽取</translation>
    </message>
    <message>
        <source>largest drawn non-linearity</source>
        <translation>随机非线性的最大值</translation>
    </message>
    <message>
        <source>{}&apos; gain error of chip {}; drawn if not given</source>
        <translation>{}&apos; 增益误差，芯片 {}；未给出时随机抽取</translation>
    </message>
    <message>
        <source>{}&apos; zero offset of chip {}; drawn if not given</source>
        <translation>{}&apos; 零偏，芯片 {}；未给出时随机抽取</translation>
    </message>
    <message>
        <source>share of {}&apos; in {}&apos; of chip {}; drawn if not given</source>
        <translation>{}&apos; 在 {}&apos; 中的占比，芯片 {}；未给出时随机抽取</translation>
    </message>
    <message>
        <source>{}&apos; place error of chip {}; drawn if not given</source>
        <translation>{}&apos; 位置误差，芯片 {}；未给出时随机抽取</translation>
    </message>
    <message>
        <source>height error of chip {}; drawn if not given</source>
        <translation>芯片 {} 的高度误差；未给出时随机抽取</translation>
    </message>
    <message>
        <source>real centre of mass along {}&apos;</source>
        <translation>沿 {}&apos; 的实际质心</translation>
    </message>
    <message>
        <source>rotation at the start</source>
        <translation>起始转角</translation>
    </message>
    <message>
        <source>pitch of the magnet matrix</source>
        <translation>磁体阵列节距</translation>
    </message>
    <message>
        <source>height of the magnet blocks</source>
        <translation>磁块高度</translation>
    </message>
    <message>
        <source>peak magnetisation of one array</source>
        <translation>单个阵列的峰值磁化强度</translation>
    </message>
    <message>
        <source>edge of the magnet matrix in pitches</source>
        <translation>磁体阵列边长（节距数）</translation>
    </message>
    <message>
        <source>width of a coil&apos;s winding</source>
        <translation>线圈绕组宽度</translation>
    </message>
    <message>
        <source>height of a coil&apos;s winding</source>
        <translation>线圈绕组高度</translation>
    </message>
    <message>
        <source>turns per width</source>
        <translation>单位宽度匝数</translation>
    </message>
    <message>
        <source>layers per height</source>
        <translation>单位高度层数</translation>
    </message>
    <message>
        <source>gap from the magnets to the coils</source>
        <translation>磁体到线圈的间隙</translation>
    </message>
    <message>
        <source>arm of coils 5 and 6</source>
        <translation>线圈 5 和 6 的力臂</translation>
    </message>
    <message>
        <source>resistance of a coil</source>
        <translation>线圈电阻</translation>
    </message>
    <message>
        <source>inductance of a coil</source>
        <translation>线圈电感</translation>
    </message>
    <message>
        <source>current limit of a coil</source>
        <translation>线圈电流限值</translation>
    </message>
    <message>
        <source>force of coil {} over its nominal one</source>
        <translation>线圈 {} 的力与标称值之比</translation>
    </message>
    <message>
        <source>current per volt of an amplifier</source>
        <translation>放大器每伏电流</translation>
    </message>
    <message>
        <source>bandwidth of an amplifier</source>
        <translation>放大器带宽</translation>
    </message>
    <message>
        <source>largest voltage at a coil</source>
        <translation>线圈最大电压</translation>
    </message>
    <message>
        <source>output resistance of an amplifier</source>
        <translation>放大器输出电阻</translation>
    </message>
    <message>
        <source>resolution of the outputs</source>
        <translation>输出分辨率</translation>
    </message>
    <message>
        <source>range of the outputs, plus and minus</source>
        <translation>输出范围，正负</translation>
    </message>
    <message>
        <source>in-plane field amplitude at the chips</source>
        <translation>芯片处的面内磁场幅值</translation>
    </message>
    <message>
        <source>place of chip {} along {}&apos;</source>
        <translation>芯片 {} 沿 {}&apos; 的位置</translation>
    </message>
    <message>
        <source>Hall noise per reading, rms</source>
        <translation>每次读数的霍尔噪声，有效值</translation>
    </message>
    <message>
        <source>field at which a chip clips</source>
        <translation>芯片饱和的磁场</translation>
    </message>
    <message>
        <source>sensitivity after conditioning</source>
        <translation>调理后的灵敏度</translation>
    </message>
    <message>
        <source>resolution of the inputs</source>
        <translation>输入分辨率</translation>
    </message>
    <message>
        <source>range of the inputs, plus and minus</source>
        <translation>输入范围，正负</translation>
    </message>
    <message>
        <source>field of the coils at the chips over the calculated one</source>
        <translation>线圈在芯片处的磁场与计算值之比</translation>
    </message>
    <message>
        <source>spread of the drawn cross-axis shares</source>
        <translation>随机交叉轴分量的离散</translation>
    </message>
    <message>
        <source>spread of the drawn places</source>
        <translation>随机位置的离散</translation>
    </message>
    <message>
        <source>spread of the drawn heights</source>
        <translation>随机高度的离散</translation>
    </message>
    <message>
        <source>stiffness of the cable</source>
        <translation>线缆刚度</translation>
    </message>
    <message>
        <source>torsion of the cable</source>
        <translation>线缆扭转刚度</translation>
    </message>
    <message>
        <source>anchor of the cable along {}&apos;</source>
        <translation>线缆固定点沿 {}&apos; 的位置</translation>
    </message>
    <message>
        <source>slow random force per axis, rms</source>
        <translation>每轴缓慢随机力，有效值</translation>
    </message>
    <message>
        <source>corner of the slow random force</source>
        <translation>缓慢随机力的转折频率</translation>
    </message>
    <message>
        <source>damping of the motion in the plane</source>
        <translation>平面运动阻尼</translation>
    </message>
    <message>
        <source>damping of the rotation</source>
        <translation>转动阻尼</translation>
    </message>
    <message>
        <source>travel from the middle to a stop</source>
        <translation>从中间到限位的行程</translation>
    </message>
    <message>
        <source>rotation from the middle to a stop</source>
        <translation>从中间到限位的转角</translation>
    </message>
    <message>
        <source>stiffness of the stops</source>
        <translation>限位刚度</translation>
    </message>
    <message>
        <source>stiffness of the stops in angle</source>
        <translation>限位转动刚度</translation>
    </message>
    <message>
        <source>damping of the stops over the critical one</source>
        <translation>限位阻尼与临界阻尼之比</translation>
    </message>
    <message>
        <source>stiffness of each air bearing</source>
        <translation>每个气浮轴承的刚度</translation>
    </message>
    <message>
        <source>heat capacity of a coil</source>
        <translation>线圈热容</translation>
    </message>
    <message>
        <source>from a coil to ambient</source>
        <translation>线圈到环境</translation>
    </message>
    <message>
        <source>error of the temperature sensors; drawn for each if not given</source>
        <translation>温度传感器误差；未给出时各自随机抽取</translation>
    </message>
    <message>
        <source>gain error of sensor {} along {}; drawn</source>
        <translation>传感器 {} 沿 {} 的增益误差；随机抽取</translation>
    </message>
    <message>
        <source>offset of sensor {} along {}; drawn</source>
        <translation>传感器 {} 沿 {} 的零偏；随机抽取</translation>
    </message>
    <message>
        <source>mounting error of sensor {} about stator {}; drawn</source>
        <translation>传感器 {} 绕定子 {} 的安装误差；随机抽取</translation>
    </message>
    <message>
        <source>place error of sensor {} along stator {}; drawn</source>
        <translation>传感器 {} 沿定子 {} 的位置误差；随机抽取</translation>
    </message>
    <message>
        <source>placement of sensor {} about {}</source>
        <translation>传感器 {} 绕 {} 的布置</translation>
    </message>
    <message>
        <source>outer radius of the rotor</source>
        <translation>转子外半径</translation>
    </message>
    <message>
        <source>radius of the rotor&apos;s core</source>
        <translation>转子芯半径</translation>
    </message>
    <message>
        <source>pole angle of the magnet</source>
        <translation>磁体极角</translation>
    </message>
    <message>
        <source>remanence</source>
        <translation>剩磁</translation>
    </message>
    <message>
        <source>relative recoil permeability</source>
        <translation>相对回复磁导率</translation>
    </message>
    <message>
        <source>relative permeability of the core</source>
        <translation>芯的相对磁导率</translation>
    </message>
    <message>
        <source>azimuthal coefficient</source>
        <translation>方位系数</translation>
    </message>
    <message>
        <source>distance of the sensors from the centre</source>
        <translation>传感器到中心的距离</translation>
    </message>
    <message>
        <source>harmonic ({}) at 50 mm instead of the preset&apos;s</source>
        <translation>50 mm 处的谐波（{}），替代预设值</translation>
    </message>
    <message>
        <source>spread of the drawn cross-axis shares, 1 sigma</source>
        <translation>随机交叉轴分量的离散，1 sigma</translation>
    </message>
    <message>
        <source>spread of the drawn mounting angles, 1 sigma</source>
        <translation>随机安装角的离散，1 sigma</translation>
    </message>
    <message>
        <source>spread of the drawn places, 1 sigma</source>
        <translation>随机位置的离散，1 sigma</translation>
    </message>
    <message>
        <source>noise of a reading, rms</source>
        <translation>读数噪声，有效值</translation>
    </message>
    <message>
        <source>uniform stray field along {}</source>
        <translation>沿 {} 的均匀杂散磁场</translation>
    </message>
    <message>
        <source>place of the stator coil, from {}</source>
        <translation>定子线圈位置，自 {} 起</translation>
    </message>
    <message>
        <source>distance of the coil&apos;s centre</source>
        <translation>线圈中心的距离</translation>
    </message>
    <message>
        <source>radius of the stator coil</source>
        <translation>定子线圈半径</translation>
    </message>
    <message>
        <source>turns of the stator coil</source>
        <translation>定子线圈匝数</translation>
    </message>
    <message>
        <source>current of the stator coil</source>
        <translation>定子线圈电流</translation>
    </message>
    <message>
        <source>temperature at the start</source>
        <translation>起始温度</translation>
    </message>
    <message>
        <source>final rise of the magnet</source>
        <translation>磁体最终温升</translation>
    </message>
    <message>
        <source>time constant of the rise</source>
        <translation>温升时间常数</translation>
    </message>
    <message>
        <source>relative change of the field with temperature</source>
        <translation>磁场随温度的相对变化</translation>
    </message>
    <message>
        <source>error of the temperature sensor; drawn</source>
        <translation>温度传感器误差；随机抽取</translation>
    </message>
    <message>
        <source>spread of the drawn temperature errors, 1 sigma</source>
        <translation>随机温度误差的离散，1 sigma</translation>
    </message>
    <message>
        <source>start, rotation about {}</source>
        <translation>起始，绕 {} 的转角</translation>
    </message>
    <message>
        <source>start, spin about the shaft</source>
        <translation>起始，绕轴的自转角</translation>
    </message>
    <message>
        <source>rate towards a set-point, spin of tumbling</source>
        <translation>趋向设定值的角速度，翻滚时的自转</translation>
    </message>
    <message>
        <source>spin along the published trajectories</source>
        <translation>沿文献轨迹的自转</translation>
    </message>
    <message>
        <source>time between two published samples</source>
        <translation>文献中两个采样点的间隔</translation>
    </message>
    <message>
        <source>tilt of tumbling, limit of the random walk</source>
        <translation>翻滚的倾角，随机游走的限值</translation>
    </message>
    <message>
        <source>frequency of tumbling about {}</source>
        <translation>绕 {} 的翻滚频率</translation>
    </message>
    <message>
        <source>random walk: rms of an axis after one second</source>
        <translation>随机游走：一秒后单轴的有效值</translation>
    </message>
    <message>
        <source>x at the start</source>
        <translation>起始 x</translation>
    </message>
    <message>
        <source>y at the start</source>
        <translation>起始 y</translation>
    </message>
    <message>
        <source>asymmetry of friction, (Kf+ - Kf-)/(Kf+ + Kf-)</source>
        <translation>摩擦不对称性，(Kf+ - Kf-)/(Kf+ + Kf-)</translation>
    </message>
    <message>
        <source>Viscous damping</source>
        <translation>粘性阻尼</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>转矩常数</translation>
    </message>
    <message>
        <source>the radius of an arc is negative</source>
        <translation>圆弧半径为负</translation>
    </message>
    <message>
        <source>Its angle says to which side it bends.</source>
        <translation>其角度决定弯曲方向。</translation>
    </message>
    <message>
        <source>{}={} has a character that divides an address</source>
        <translation>{}={} 含有地址分隔符</translation>
    </message>
    <message>
        <source>Leave out &amp; ? #.</source>
        <translation>请去掉 &amp; ? #。</translation>
    </message>
    <message>
        <source>a {} has no {}</source>
        <translation>{} 没有 {}</translation>
    </message>
    <message>
        <source>the radius of an arc is positive</source>
        <translation>圆弧半径为正</translation>
    </message>
    <message>
        <source>The sign of angle_deg says whether it bends to the left (positive) or to the right.</source>
        <translation>angle_deg 的符号决定向左（正）或向右弯曲。</translation>
    </message>
    <message>
        <source>check the value and the board&apos;s state</source>
        <translation>检查该值和控制板的状态</translation>
    </message>
    <message>
        <source>the line has lost or damaged packets (so far {}): check the line, then the value and the board&apos;s state</source>
        <translation>线路丢失或损坏过数据包（至今 {} 个）：先检查线路，再检查该值和控制板的状态</translation>
    </message>
    <message>
        <source>the connection was lost once and came back</source>
        <translation>连接中断过一次后恢复</translation>
    </message>
    <message>
        <source>the connection was lost {} times and came back</source>
        <translation>连接中断过 {} 次后恢复</translation>
    </message>
    <message>
        <source>check the cable, the plug and the power of the device</source>
        <translation>检查设备的电缆、插头和电源</translation>
    </message>
    <message>
        <source>the sample recording &apos;{}&apos; cannot be read</source>
        <translation>无法读取示例记录 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>install the program again</source>
        <translation>请重新安装程序</translation>
    </message>
    <message>
        <source>the sample recording cannot be copied to &apos;{}&apos;: {}</source>
        <translation>无法将示例记录复制到 &apos;{}&apos;：{}</translation>
    </message>
    <message>
        <source>Path that x and y (of a table all axes) follow from the next start on, once, instead of references</source>
        <translation>x 和 y（表格时为所有轴）从下次启动起跟随一次的轨迹，替代参考信号</translation>
    </message>
    <message>
        <source>Where a piece begins, from where the motion began</source>
        <translation>一段的起点，自运动起点计</translation>
    </message>
    <message>
        <source>At the beginning of the piece</source>
        <translation>段起点处的值</translation>
    </message>
    <message>
        <source>During the piece</source>
        <translation>段内的值</translation>
    </message>
    <message>
        <source>How long the piece lasts</source>
        <translation>段的时长</translation>
    </message>
    <message>
        <source>Writing n stores the piece as number n of the table</source>
        <translation>写入 n 将该段存为表格第 n 段</translation>
    </message>
    <message>
        <source>Pieces that path.shape = table follows</source>
        <translation>path.shape = table 时跟随的段数</translation>
    </message>
    <message>
        <source>a motion without poses</source>
        <translation>运动没有位姿</translation>
    </message>
    <message>
        <source>Give at least one pose.</source>
        <translation>请至少给出一个位姿。</translation>
    </message>
    <message>
        <source>poses with different numbers of axes</source>
        <translation>各位姿的轴数不同</translation>
    </message>
    <message>
        <source>Give every axis in every row.</source>
        <translation>请在每一行给出每个轴。</translation>
    </message>
    <message>
        <source>a pose is not a number</source>
        <translation>某个位姿不是数字</translation>
    </message>
    <message>
        <source>Give finite poses.</source>
        <translation>请给出有限的位姿。</translation>
    </message>
    <message>
        <source>the poses move nothing</source>
        <translation>这些位姿不产生运动</translation>
    </message>
    <message>
        <source>Poses count from where the axes stand: give one that differs from 0.</source>
        <translation>位姿从各轴当前位置计：请给出一个非 0 的位姿。</translation>
    </message>
    <message>
        <source>not as many times as poses</source>
        <translation>时间与位姿的数目不同</translation>
    </message>
    <message>
        <source>Give a time for every pose.</source>
        <translation>请为每个位姿给出时间。</translation>
    </message>
    <message>
        <source>a time of a pose is not a number</source>
        <translation>某个位姿的时间不是数字</translation>
    </message>
    <message>
        <source>Give finite times.</source>
        <translation>请给出有限的时间。</translation>
    </message>
    <message>
        <source>the times of poses do not increase</source>
        <translation>位姿的时间没有递增</translation>
    </message>
    <message>
        <source>Sort the rows; times begin at 0 or later.</source>
        <translation>请对各行排序；时间从 0 或更晚开始。</translation>
    </message>
    <message>
        <source>at time 0 the pose is not 0</source>
        <translation>时间 0 处的位姿不为 0</translation>
    </message>
    <message>
        <source>Poses count from where the axes stand when they start: begin with zeros, or later.</source>
        <translation>位姿从启动时各轴的位置计：请以零开始，或推迟开始时间。</translation>
    </message>
    <message>
        <source>radius; of a circle the centre lies along the first axis</source>
        <translation>半径；圆的圆心位于第一轴方向</translation>
    </message>
    <message>
        <source>turns of a circle</source>
        <translation>圆的圈数</translation>
    </message>
    <message>
        <source>length of the lines of a raster, along the first axis</source>
        <translation>栅格各行的长度，沿第一轴</translation>
    </message>
    <message>
        <source>from line to line of a raster, along the second axis</source>
        <translation>栅格行间距，沿第二轴</translation>
    </message>
    <message>
        <source>lines of a raster</source>
        <translation>栅格的行数</translation>
    </message>
    <message>
        <source>angle of an arc, counter-clockwise</source>
        <translation>圆弧的角度，逆时针</translation>
    </message>
    <message>
        <source>start direction of arc and line, from first to second axis</source>
        <translation>圆弧和直线的起始方向，从第一轴转向第二轴</translation>
    </message>
    <message>
        <source>length of a line</source>
        <translation>直线的长度</translation>
    </message>
    <message>
        <source>rest in every row of a table without time_s</source>
        <translation>无 time_s 的表格在每行的停留时间</translation>
    </message>
    <message>
        <source>a {} has no file</source>
        <translation>{} 没有文件</translation>
    </message>
    <message>
        <source>Only a table has a file of poses.</source>
        <translation>只有表格才有位姿文件。</translation>
    </message>
    <message>
        <source>Write a header like time_s,x_mm,y_mm,phi_mrad.</source>
        <translation>请写出类似 time_s,x_mm,y_mm,phi_mrad 的表头。</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; has no unit in its name</source>
        <translation>列“{}”的名称中没有单位</translation>
    </message>
    <message>
        <source>column &apos;{}&apos;: &apos;{}&apos; is no unit of a {}</source>
        <translation>列“{}”：“{}”不是{}的单位</translation>
    </message>
    <message>
        <source>length or an angle</source>
        <translation>长度或角度</translation>
    </message>
    <message>
        <source>Write time_s or time_ms.</source>
        <translation>请写 time_s 或 time_ms。</translation>
    </message>
    <message>
        <source>Write e.g. x_mm, x_m, phi_mrad or phi_deg.</source>
        <translation>请写例如 x_mm、x_m、phi_mrad 或 phi_deg。</translation>
    </message>
    <message>
        <source>At most {} are read.</source>
        <translation>最多读取 {} 个。</translation>
    </message>
    <message>
        <source>a quoted cell does not end</source>
        <translation>带引号的单元格没有结束</translation>
    </message>
    <message>
        <source>Write numbers without quotes.</source>
        <translation>请不要给数字加引号。</translation>
    </message>
    <message>
        <source>the time is given twice</source>
        <translation>时间给出了两次</translation>
    </message>
    <message>
        <source>axis {} is given twice, as {} and {}</source>
        <translation>轴 {} 给出了两次：{} 和 {}</translation>
    </message>
    <message>
        <source>Keep one of the columns.</source>
        <translation>请只保留其中一列。</translation>
    </message>
    <message>
        <source>the table has no column of an axis</source>
        <translation>表格中没有轴的列</translation>
    </message>
    <message>
        <source>{} has no value</source>
        <translation>{} 没有值</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a finite number ({})</source>
        <translation>“{}”不是有限的数字（{}）</translation>
    </message>
    <message>
        <source>Write numbers like -1{}5e-3 in every cell.</source>
        <translation>请在每个单元格写入类似 -1{}5e-3 的数字。</translation>
    </message>
    <message>
        <source>the time is negative</source>
        <translation>时间为负</translation>
    </message>
    <message>
        <source>Times count from the start of the motion.</source>
        <translation>时间从运动开始计。</translation>
    </message>
    <message>
        <source>time {} s comes after {} s</source>
        <translation>时间 {} s 出现在 {} s 之后</translation>
    </message>
    <message>
        <source>Sort the rows by time, each time once.</source>
        <translation>请按时间对各行排序，每个时间只出现一次。</translation>
    </message>
    <message>
        <source>more than {} rows</source>
        <translation>超过 {} 行</translation>
    </message>
    <message>
        <source>Split the table.</source>
        <translation>请拆分表格。</translation>
    </message>
    <message>
        <source>{} cells, but the header has {} columns</source>
        <translation>有 {} 个单元格，但表头有 {} 列</translation>
    </message>
    <message>
        <source>Give every column a value; the separator is that of the header.</source>
        <translation>请为每一列给出值；分隔符与表头相同。</translation>
    </message>
    <message>
        <source>the table has no rows</source>
        <translation>表格没有数据行</translation>
    </message>
    <message>
        <source>the table has one row only</source>
        <translation>表格只有一行</translation>
    </message>
    <message>
        <source>Give two poses or more, a line each. For one pose use a travel, e.g. s-curve.</source>
        <translation>请给出两个或更多位姿，每行一个。单个位姿请使用行程，例如 s-curve。</translation>
    </message>
    <message>
        <source>{}: the table has {} octets, {} are read</source>
        <translation>{}：表格有 {} 字节，最多读取 {}</translation>
    </message>
    <message>
        <source>Split the table; {} rows are the most.</source>
        <translation>请拆分表格；最多 {} 行。</translation>
    </message>
    <message>
        <source>{}: the file is no text</source>
        <translation>{}：文件不是文本</translation>
    </message>
    <message>
        <source>without time_s the way to {} needs {}</source>
        <translation>没有 time_s 时，到 {} 的运动需要 {}</translation>
    </message>
    <message>
        <source>Add {}=... to the reference, or a column time_s to the table.</source>
        <translation>请在参考信号中加入 {}=...，或在表格中加入 time_s 列。</translation>
    </message>
    <message>
        <source>{}: row {}: axis {} {} {} {}{}, the limit is {} {}{} ({})</source>
        <translation>{}：第 {} 行：轴 {} {} {} {}{}，限值为 {} {}{}（{}）</translation>
    </message>
    <message>
        <source>Use poses nearer to the start, or a wider window. Nothing moved.</source>
        <translation>请使用更靠近起点的位姿，或加大窗口。没有任何运动。</translation>
    </message>
    <message>
        <source>Give the row more time, or bring it nearer to the one before. Nothing moved.</source>
        <translation>请给该行更多时间，或使其更接近前一行。没有任何运动。</translation>
    </message>
    <message>
        <source>moves at</source>
        <translation>的速度为</translation>
    </message>
    <message>
        <source>rate of the reference</source>
        <translation>参考信号的 rate</translation>
    </message>
    <message>
        <source>accelerates at</source>
        <translation>的加速度为</translation>
    </message>
    <message>
        <source>acceleration of the reference</source>
        <translation>参考信号的 acceleration</translation>
    </message>
    <message>
        <source>has a jerk of</source>
        <translation>的加加速度为</translation>
    </message>
    <message>
        <source>jerk of the reference</source>
        <translation>参考信号的 jerk</translation>
    </message>
    <message>
        <source>dwell_s is for tables without time_s</source>
        <translation>dwell_s 用于没有 time_s 的表格</translation>
    </message>
    <message>
        <source>Leave it out: two rows with the same pose are a pause.</source>
        <translation>请省略：两行相同的位姿即为停顿。</translation>
    </message>
    <message>
        <source>{}: the device has no axis &apos;{}&apos; ({})</source>
        <translation>{}：设备没有轴“{}”（{}）</translation>
    </message>
    <message>
        <source>Its axes: {}.</source>
        <translation>它的轴：{}。</translation>
    </message>
    <message>
        <source>{}: axis {} is in {}, not in {} ({})</source>
        <translation>{}：轴 {} 的单位是 {}，不是 {}（{}）</translation>
    </message>
    <message>
        <source>Name the column {}_{}.</source>
        <translation>请将该列命名为 {}_{}。</translation>
    </message>
    <message>
        <source>{}: the way takes {} pieces, the board has room for {}</source>
        <translation>{}：该运动需要 {} 段，控制板可容纳 {} 段</translation>
    </message>
    <message>
        <source>Split the table, or use fewer rows.</source>
        <translation>请拆分表格，或减少行数。</translation>
    </message>
    <message>
        <source>{}: row {}: the way takes {} s, the board takes up to {} s</source>
        <translation>{}：第 {} 行：该段运动需要 {} s，控制板最多接受 {} s</translation>
    </message>
    <message>
        <source>Add rows in between.</source>
        <translation>请在中间加入行。</translation>
    </message>
    <message>
        <source>a table needs file</source>
        <translation>表格需要 file</translation>
    </message>
    <message>
        <source>Add file=POSES.csv to the reference.</source>
        <translation>请在参考信号中加入 file=POSES.csv。</translation>
    </message>
    <message>
        <source>a table has no amplitude and no constant motion</source>
        <translation>表格没有幅值，也没有匀速运动</translation>
    </message>
    <message>
        <source>Write both into its rows.</source>
        <translation>请将二者写入各行。</translation>
    </message>
    <message>
        <source>this device follows no table of poses</source>
        <translation>该设备不支持位姿表</translation>
    </message>
    <message>
        <source>Move one axis: a step, a ramp, a staircase.</source>
        <translation>请移动单个轴：阶跃、斜坡、阶梯。</translation>
    </message>
    <message>
        <source>the table of the reference was not read</source>
        <translation>尚未读取参考信号的表格</translation>
    </message>
    <message>
        <source>Read the file before the move.</source>
        <translation>请在运动前读取文件。</translation>
    </message>
    <message>
        <source>goes as far as</source>
        <translation>到达</translation>
    </message>
    <message>
        <source>largest force over inertia</source>
        <translation>最大力除以惯量</translation>
    </message>
    <message>
        <source>Poses count from where the axes stand: move them nearer to the middle first. Nothing moved.</source>
        <translation>位姿从各轴当前位置计：请先将其移近中间。没有任何运动。</translation>
    </message>
    <message>
        <source>a table moves the axes of its columns</source>
        <translation>表格移动其各列对应的轴</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>It swings out between two rows: use more even times, or a pause. Nothing moved.</source>
        <translation>轴在两行之间摆出：请使用更均匀的时间，或加入停顿。没有任何运动。</translation>
    </message>
    <message>
        <source>the rate of a table is negative</source>
        <translation>表格的速度为负</translation>
    </message>
    <message>
        <source>Give the largest speed without a sign; the rows say the direction.</source>
        <translation>请给出不带符号的最大速度；方向由各行给出。</translation>
    </message>
    <message>
        <source>{}: row {}: axis {} would come to {} {}, its travel ends at {} {}</source>
        <translation>{}：第 {} 行：轴 {} 将到达 {} {}，其行程止于 {} {}</translation>
    </message>
    <message>
        <source>alpha {}, beta {}, gamma {} deg</source>
        <translation>alpha {}、beta {}、gamma {} 度</translation>
    </message>
    <message>
        <source>gamma about Z first, then beta about Y, then alpha about X</source>
        <translation>先绕 Z 转 gamma，再绕 Y 转 beta，最后绕 X 转 alpha</translation>
    </message>
    <message>
        <source>alpha about X first, then beta about Y, then gamma about Z</source>
        <translation>先绕 X 转 alpha，再绕 Y 转 beta，最后绕 Z 转 gamma</translation>
    </message>
    <message>
        <source>alpha about X first, then beta about Y, then gamma about Z, without the roll about the radius</source>
        <translation>先绕 X 转 alpha，再绕 Y 转 beta，最后绕 Z 转 gamma，不含绕半径的滚转</translation>
    </message>
    <message>
        <source>orientations that are missing most: {} ({})</source>
        <translation>最缺的姿态：{}（{}）</translation>
    </message>
    <message>
        <source>the placement angles of a sensor turn it in this order: {}</source>
        <translation>传感器的布置角按此顺序转动传感器：{}</translation>
    </message>
    <message>
        <source>Its values turn_x, turn_y and turn_z are one rotation vector along the stator&apos;s axes.</source>
        <translation>其 turn_x、turn_y、turn_z 是沿定子轴的一个旋转矢量。</translation>
    </message>
    <message>
        <source>No row with all nine readings has come yet.</source>
        <translation>尚未收到含全部九个读数的行。</translation>
    </message>
    <message>
        <source>Wait a second, then compare again.</source>
        <translation>请等待一秒，然后再次比较。</translation>
    </message>
    <message>
        <source>fault of channel {} of sensor {}</source>
        <translation>{} 通道故障，传感器 {}</translation>
    </message>
    <message>
        <source>device model: exact, or additive angles as published</source>
        <translation>器件模型：精确（exact），或按文献的角度相加（paper）</translation>
    </message>
    <message>
        <source>how placement angles turn a sensor; nat is unrolled</source>
        <translation>放置角如何转动传感器；nat 无滚转</translation>
    </message>
    <message>
        <source>further harmonics: h1 as finite elements, h2 stress</source>
        <translation>附加谐波：h1 按有限元，h2 强化</translation>
    </message>
    <message>
        <source>range of the converter: 12 bit, 130mT in steps of 98 uT</source>
        <translation>转换器量程：12 位，130mT 步长 98 µT</translation>
    </message>
    <message>
        <source>motion of the rotor; published1 to published4 are trajectories</source>
        <translation>转子运动；published1 至 published4 为轨迹</translation>
    </message>
    <message>
        <source>Allowed: {}.</source>
        <translation>允许：{}。</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}{}. Known keys: {}.</source>
        <translation>允许：{} 到 {}{}{}。已知的键：{}。</translation>
    </message>
    <message>
        <source>noise of a usual part: noise_uT is 0, 25, 100 or 1000 uT</source>
        <translation>常见器件的噪声：noise_uT 为 0、25、100 或 1000 µT</translation>
    </message>
    <message>
        <source>Set-point of the rotation about X; a change ends another motion</source>
        <translation>绕 X 转动的设定值；结束其他运动</translation>
    </message>
    <message>
        <source>Set-point of the rotation about Y; a change ends another motion</source>
        <translation>绕 Y 转动的设定值；结束其他运动</translation>
    </message>
    <message>
        <source>Set-point of the rotation about Z; a change ends another motion</source>
        <translation>绕 Z 转动的设定值；结束其他运动</translation>
    </message>
    <message>
        <source>Fault of this channel, of a simulation only</source>
        <translation>该通道的故障，仅用于模拟</translation>
    </message>
    <message>
        <source>Largest rate towards the set-point</source>
        <translation>转向设定值的最大转速</translation>
    </message>
    <message>
        <source>Current that the simulation drives through the coil</source>
        <translation>模拟中通过线圈的电流</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Move the rotor there too. A simulated rotor moves with motion=tumble or motion=walk in its address.</source>
        <translation>请把转子也转到这些姿态。模拟转子在地址中加 motion=tumble 或 motion=walk 即可运动。</translation>
    </message>
    <message>
        <source>Use the objective coverage, or the exact device.</source>
        <translation>请使用目标 coverage，或使用精确模型。</translation>
    </message>
    <message>
        <source>Sensor 0, which stays on +X, reads up to {} mT: more than the range of {} mT.</source>
        <translation>固定在 +X 的传感器 0 读数可达 {} mT：超过量程 {} mT。</translation>
    </message>
    <message>
        <source>Use a range of at least {} mT, or sensors {} mm or more from the centre.</source>
        <translation>请使用至少 {} mT 的量程，或使传感器距中心 {} mm 或更远。</translation>
    </message>
    <message>
        <source>Use 1, 1.5, 2.5, 3, 4.5, 5, 7.5, 9, 15, 22.5 or 45 degrees.</source>
        <translation>请使用 1、1.5、2.5、3、4.5、5、7.5、9、15、22.5 或 45 度。</translation>
    </message>
    <message>
        <source>Check the radius of the sensors, the strength of the rotor and the noise.</source>
        <translation>请检查传感器半径、转子强度和噪声。</translation>
    </message>
    <message>
        <source>dead</source>
        <translation>无信号</translation>
    </message>
    <message>
        <source>stuck</source>
        <translation>卡死</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>超量程</translation>
    </message>
    <message>
        <source>look for a jump of the angle in the recording, then measure again</source>
        <translation>请在记录中查找角度的跳变，然后重新测量</translation>
    </message>
    <message>
        <source>record longer</source>
        <translation>请延长记录时间</translation>
    </message>
    <message>
        <source>check the temperature sensors</source>
        <translation>请检查温度传感器</translation>
    </message>
    <message>
        <source>the compensation of the stray field leaves {} deg per ampere, more than it should</source>
        <translation>杂散磁场补偿后每安培仍剩余 {} 度，超出应有的值</translation>
    </message>
    <message>
        <source>calibrate the stray field, then measure again</source>
        <translation>请标定杂散磁场，然后重新测量</translation>
    </message>
    <message>
        <source>the platen has no room for a pitch of {} mm along {}: it may move from {} to {} mm, and there only on lines that are {} mm apart</source>
        <translation>动子在 {1} 方向上没有一个节距 {0} mm 的空间：允许范围为 {2} 至 {3} mm，并且只能沿间距 {4} mm 的线移动</translation>
    </message>
    <message>
        <source>goes to the middle</source>
        <translation>移向中间</translation>
    </message>
    <message>
        <source>{}; axis {} was {} {} from where it began</source>
        <translation>{}；轴 {} 已离开起点 {} {}</translation>
    </message>
    <message>
        <source>{} of {} orientations do not fit the calibrated model</source>
        <translation>{1} 个姿态中有 {0} 个与标定模型不符</translation>
    </message>
    <message>
        <source>Check for harmonics of the field beyond those that are fitted, a loose sensor or iron near the rotor.</source>
        <translation>检查是否存在拟合之外的磁场谐波、松动的传感器或转子附近的铁磁物体。</translation>
    </message>
    <message>
        <source>a {} needs {}_deg{} or {}_mm{}</source>
        <translation>{} 需要 {}_deg{} 或 {}_mm{}</translation>
    </message>
    <message>
        <source>Add {}_deg{}=... or {}_mm{}=... to the reference.</source>
        <translation>在参考值中加入 {}_deg{}=... 或 {}_mm{}=...。</translation>
    </message>
    <message>
        <source>axis {} would come to {} {}, its travel ends at {} {}</source>
        <translation>轴 {} 将到达 {} {}，其行程终点为 {} {}</translation>
    </message>
    <message>
        <source>A reference counts from where the axis stands, now {} {}: move it nearer to the middle first, or less far. Nothing moved.</source>
        <translation>参考值从轴的当前位置 {} {} 算起：请先移近中间，或减小移动量。未发生运动。</translation>
    </message>
    <message>
        <source>{}: {} is {} rad, more than a turn</source>
        <translation>{}：{} 为 {} rad，超过一圈</translation>
    </message>
    <message>
        <source>Name columns in degrees alpha_deg, beta_deg, gamma_deg.</source>
        <translation>以度为单位的列请命名为 alpha_deg、beta_deg、gamma_deg。</translation>
    </message>
    <message>
        <source>fault of chip {}</source>
        <translation>芯片 {} 的故障</translation>
    </message>
    <message>
        <source>time after which chips have their faults</source>
        <translation>芯片出现故障前的时间</translation>
    </message>
    <message>
        <source>model of the coils' forces, section 5</source>
        <translation>线圈力模型，第 5 节</translation>
    </message>
    <message>
        <source>Widen window.x and window.y. The platen was moved; nothing was changed.</source>
        <translation>请加宽 window.x 和 window.y。动子已移动；未作任何更改。</translation>
    </message>
    <message>
        <source>Write tilts within a turn.</source>
        <translation>请把倾角写在一圈以内。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ArmButton</name>
    <message>
        <source>Enable motion; set-points start at zero (Ctrl+Shift+A)</source>
        <translation>允许运动；设定值从零开始 (Ctrl+Shift+A)</translation>
    </message>
    <message>
        <source>Switch the current off, set-points to zero (Ctrl+Shift+A)</source>
        <translation>关闭电流，设定值归零 (Ctrl+Shift+A)</translation>
    </message>
    <message>
        <source>Keep hands, hair, cables and loose parts clear. Esc stops it.</source>
        <translation>请让手、头发、线缆和松动物件远离。按 Esc 停止。</translation>
    </message>
    <message>
        <source>When armed, the actuator can move at any time.</source>
        <translation>使能后，执行器随时可能运动。</translation>
    </message>
    <message>
        <source>Arm it</source>
        <translation>确认使能</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>解除使能</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>使能</translation>
    </message>
</context>
<context>
    <name>halbench::app::ArrangementNotice</name>
    <message>
        <source>The old layout stays in the file as %1.</source>
        <translation>原布局以名称 %1 保留在文件中。</translation>
    </message>
    <message>
        <source>The panel layout in %1 is from an older version. The default layout is shown.</source>
        <translation>%1 中的面板布局来自更旧的版本。显示默认布局。</translation>
    </message>
    <message>
        <source>The panel layout in %1 is from a newer version. The default layout is shown.</source>
        <translation>%1 中的面板布局来自更新的版本。显示默认布局。</translation>
    </message>
    <message>
        <source>The panel layout in %1 is damaged. The default layout is shown.</source>
        <translation>%1 中的面板布局已损坏。显示默认布局。</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibratePanel</name>
    <message>
        <source>The actuator moves (Ctrl+Return); Esc stops it</source>
        <translation>执行器会运动 (Ctrl+Return)；按 Esc 停止</translation>
    </message>
    <message>
        <source>Field per ampere of every coil in every chip</source>
        <translation>各线圈每安培在各芯片处的磁场</translation>
    </message>
    <message>
        <source>Amplitude, gains, cross-axis shares, offsets and places of every chip</source>
        <translation>各芯片的幅值、增益、交叉轴分量、零偏和位置</translation>
    </message>
    <message>
        <source>Measures the errors of the field sensors and the field of the coils in them.</source>
        <translation>测量磁场传感器的误差以及线圈在其中产生的磁场。</translation>
    </message>
    <message>
        <source>Applied and read back. Lost when the simulated device is disconnected.</source>
        <translation>已应用并回读。仿真设备断开后丢失。</translation>
    </message>
    <message>
        <source>Not on the device yet: press Apply to write the values. Calibrate again after any work on the sensors.</source>
        <translation>尚未写入设备：按“应用”写入。传感器改动后请重新标定。</translation>
    </message>
    <message>
        <source>These values are on the device.</source>
        <translation>设备已有这些值。</translation>
    </message>
    <message>
        <source>Breakaway current over the angle, both directions</source>
        <translation>起动电流随角度的变化（双向）</translation>
    </message>
    <message>
        <source>Distance of the readings from the ellipse over the angle</source>
        <translation>读数与椭圆的距离随角度的变化</translation>
    </message>
    <message>
        <source>Hall sensor readings and the fitted ellipse</source>
        <translation>霍尔传感器读数及拟合椭圆</translation>
    </message>
    <message>
        <source>Valid only for the device it was measured on. Calibrate again after any work on the sensors.</source>
        <translation>仅对测量时的设备有效。传感器改动后请重新标定。</translation>
    </message>
    <message>
        <source>Hall sensor readings; centre, axes and tilt of the ellipse are measured</source>
        <translation>霍尔传感器读数；测量椭圆的中心、轴长和倾角</translation>
    </message>
    <message>
        <source>Previous values restored.</source>
        <translation>已恢复之前的值。</translation>
    </message>
    <message>
        <source>Applied and read back. Lost at power-off.</source>
        <translation>已应用并回读。断电后丢失。</translation>
    </message>
    <message>
        <source>Calibration cancelled. Nothing was changed.</source>
        <translation>标定已取消。未更改任何内容。</translation>
    </message>
    <message>
        <source>Back to the settings</source>
        <translation>返回设置</translation>
    </message>
    <message>
        <source>Write all proposed values together, then read them back</source>
        <translation>一次写入全部建议值并回读</translation>
    </message>
    <message>
        <source>For information: changes no parameter</source>
        <translation>仅供参考：不改变参数</translation>
    </message>
    <message>
        <source>Offsets, gain ratio, orthogonality error and amplitude from the ellipse</source>
        <translation>由椭圆得到偏置、增益比、正交误差和幅值</translation>
    </message>
    <message>
        <source>Measures the errors of the angle sensors, the stray field of the coils and the breakaway current.</source>
        <translation>测量角度传感器的误差、线圈的杂散磁场和起动电流。</translation>
    </message>
    <message>
        <source>Records a minute (Ctrl+Return) while you move the rotor; Esc stops it</source>
        <translation>在您转动转子时记录一分钟（Ctrl+回车）；Esc 停止</translation>
    </message>
    <message>
        <source>Field per ampere in every channel; the current of the coil has to change</source>
        <translation>每个通道中每安培的磁场；线圈电流必须变化</translation>
    </message>
    <message>
        <source>Gains, offsets, skews, frames and places of three sensors from a minute of motion</source>
        <translation>由一分钟的运动求出三个传感器的增益、偏置、斜交、坐标轴和位置</translation>
    </message>
    <message>
        <source>Finds gains, offsets, frames and places of the field sensors, and the field of the rotor, from a motion that you make.</source>
        <translation>根据您所做的运动求出磁场传感器的增益、偏置、坐标轴和位置，以及转子磁场。</translation>
    </message>
    <message>
        <source>Save calibration</source>
        <translation>保存标定</translation>
    </message>
    <message>
        <source>Calibration (*.json)</source>
        <translation>标定 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Ha&amp;ll sensors</source>
        <translation>霍尔传感器(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Stray field of the coils</source>
        <translation>线圈的杂散磁场(&amp;S)</translation>
    </message>
    <message>
        <source>Without it the recommended gains are unstable</source>
        <translation>缺少此项时推荐增益不稳定</translation>
    </message>
    <message>
        <source>Static fr&amp;iction</source>
        <translation>静摩擦(&amp;I)</translation>
    </message>
    <message>
        <source>Start calibration</source>
        <translation>开始标定</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Write the values from before the calibration</source>
        <translation>写回标定前的值</translation>
    </message>
    <message>
        <source>Save calibration…</source>
        <translation>保存标定…</translation>
    </message>
    <message>
        <source>Write the result as a file</source>
        <translation>将结果写成文件</translation>
    </message>
    <message>
        <source>Calibrate again</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>正在标定</translation>
    </message>
    <message>
        <source>Calibrated values</source>
        <translation>标定值</translation>
    </message>
    <message>
        <source>Hall ellipse</source>
        <translation>霍尔椭圆</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>静摩擦</translation>
    </message>
    <message>
        <source>Pictures of the calibration</source>
        <translation>标定图形</translation>
    </message>
    <message>
        <source>On the device</source>
        <translation>设备上</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>The rotor moves (Ctrl+Return); Esc stops it</source>
        <translation>转子会运动（Ctrl+Return）；按 Esc 键停止</translation>
    </message>
    <message>
        <source>Identify next</source>
        <translation>下一步：辨识</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrateWords</name>
    <message>
        <source>Motion over more than a pitch in each direction for %1 minutes of device time, up to %2 A in a coil. Nothing is changed until you press Apply.</source>
        <translation>沿各方向运动超过一个极距，设备时间 %1 分钟，线圈电流最大 %2 A。按下应用之前不作任何更改。</translation>
    </message>
    <message>
        <source>chip %1: amplitude of the field</source>
        <translation>芯片 %1：磁场幅值</translation>
    </message>
    <message>
        <source>chip %1: gain error along x&apos;</source>
        <translation>芯片 %1：x&apos; 方向增益误差</translation>
    </message>
    <message>
        <source>chip %1: gain error along y&apos;</source>
        <translation>芯片 %1：y&apos; 方向增益误差</translation>
    </message>
    <message>
        <source>chip %1: share of y&apos; in x&apos;</source>
        <translation>芯片 %1：x&apos; 中 y&apos; 的份额</translation>
    </message>
    <message>
        <source>chip %1: share of x&apos; in y&apos;</source>
        <translation>芯片 %1：y&apos; 中 x&apos; 的份额</translation>
    </message>
    <message>
        <source>chip %1: offset along x&apos;</source>
        <translation>芯片 %1：x&apos; 方向偏移</translation>
    </message>
    <message>
        <source>chip %1: offset along y&apos;</source>
        <translation>芯片 %1：y&apos; 方向偏移</translation>
    </message>
    <message>
        <source>chip %1: place along x&apos;</source>
        <translation>芯片 %1：x&apos; 方向位置</translation>
    </message>
    <message>
        <source>chip %1: place along y&apos;</source>
        <translation>芯片 %1：y&apos; 方向位置</translation>
    </message>
    <message>
        <source>field of coil %1 at chip %2 along %3</source>
        <translation>线圈 %1 在芯片 %2 处沿 %3 的磁场</translation>
    </message>
    <message>
        <source>periodic error along %1, before</source>
        <translation>沿 %1 的周期误差，标定前</translation>
    </message>
    <message>
        <source>periodic error along %1, remaining</source>
        <translation>沿 %1 的周期误差，剩余</translation>
    </message>
    <message>
        <source>Measured before this connection, device %1.</source>
        <translation>在本次连接之前测得，设备 %1。</translation>
    </message>
    <message>
        <source>Device stops at %1 %2. Nothing is changed until you press Apply.</source>
        <translation>转速达到 %1 %2 时设备停止。按“应用”之前不更改任何内容。</translation>
    </message>
    <message>
        <source>The breakaway current starts the rotor from rest. Identify gives another figure: K_f/φ, the friction current during rotation, usually less.</source>
        <translation>起动电流使转子从静止开始转动。辨识得到的是另一个量：K_f/φ，即转动时的摩擦电流，通常更小。</translation>
    </message>
    <message>
        <source>Root mean square over one turn of the difference between measured angle and ellipse angle, before the map.</source>
        <translation>一转内测得角度与椭圆角度之差的均方根，未经修正表。</translation>
    </message>
    <message>
        <source>Residual angle error: %1 with the previous values, %2 with the proposed values.</source>
        <translation>残余角度误差：原有值 %1，建议值 %2。</translation>
    </message>
    <message>
        <source>breakaway current</source>
        <translation>起动电流</translation>
    </message>
    <message>
        <source>angle error removed by the map, rms</source>
        <translation>修正表消除的角度误差，均方根</translation>
    </message>
    <message>
        <source>angle error, harmonic %1, sine</source>
        <translation>角度误差，%1 次谐波，正弦</translation>
    </message>
    <message>
        <source>angle error, harmonic %1, cosine</source>
        <translation>角度误差，%1 次谐波，余弦</translation>
    </message>
    <message>
        <source>unknown device</source>
        <translation>未知设备</translation>
    </message>
    <message>
        <source>Static friction: the current rises to %1 or until the rotor starts, %2 times in each direction.</source>
        <translation>静摩擦：电流升至 %1 或转子起动为止，每个方向 %2 次。</translation>
    </message>
    <message>
        <source>Stray field: the rotor is held at three angles with up to %1, without torque.</source>
        <translation>杂散磁场：转子在三个角度以最大 %1 保持，无转矩。</translation>
    </message>
    <message>
        <source>Hall: slow rotation in both directions at %1.</source>
        <translation>霍尔：以 %1 双向缓慢转动。</translation>
    </message>
    <message>
        <source>orthogonality error of the Hall sensors</source>
        <translation>霍尔传感器的正交误差</translation>
    </message>
    <message>
        <source>gain ratio B/A</source>
        <translation>增益比 B/A</translation>
    </message>
    <message>
        <source>Angle error, rms: %1 with the values from before in this record, %2 expected with the proposed ones.</source>
        <translation>角度误差均方根：本次记录中原有值为 %1，预计采用建议值后为 %2。</translation>
    </message>
    <message>
        <source>Move the rotor: tilt it and spin it.</source>
        <translation>请转动转子：倾斜并自转。</translation>
    </message>
    <message>
        <source>The motion determines every value. More of it makes the intervals smaller.</source>
        <translation>该运动已能确定所有值。继续运动可缩小区间。</translation>
    </message>
    <message>
        <source>Move the rotor by hand for a minute: tilt it to all sides, up to 45°, and spin it. A simulated rotor moves with motion=tumble in its address. The sphere shows which directions of the shaft still need data.
Nothing is armed. The calibration changes when you apply it; a simulated coil is switched meanwhile and set back.</source>
        <translation>用手转动转子一分钟：向各个方向倾斜至 45° 并自转。模拟转子在地址中加 motion=tumble 即可运动。球面显示轴的哪些方向仍缺数据。
不会使能任何输出。应用后标定才会改变；期间模拟线圈会被切换，之后恢复。</translation>
    </message>
    <message>
        <source>error left in a reading</source>
        <translation>读数的剩余误差</translation>
    </message>
    <message>
        <source>noise of a reading</source>
        <translation>单个读数的噪声</translation>
    </message>
    <message>
        <source>drift of the field with temperature</source>
        <translation>磁场随温度的漂移</translation>
    </message>
    <message>
        <source>strength q of the rotor&apos;s field</source>
        <translation>转子磁场强度 q</translation>
    </message>
    <message>
        <source>harmonic (%1)</source>
        <translation>谐波 (%1)</translation>
    </message>
    <message>
        <source>coil field %1 of sensor %2</source>
        <translation>传感器 %2 的线圈磁场 %1</translation>
    </message>
    <message>
        <source>place along %1 of sensor %2</source>
        <translation>传感器 %2 沿 %1 的位置</translation>
    </message>
    <message>
        <source>frame about %1 of sensor %2</source>
        <translation>传感器 %2 绕 %1 的坐标轴转角</translation>
    </message>
    <message>
        <source>offset %1 of sensor %2</source>
        <translation>传感器 %2 的偏置 %1</translation>
    </message>
    <message>
        <source>cross-axis share %1 of sensor %2</source>
        <translation>传感器 %2 的交叉轴份额 %1</translation>
    </message>
    <message>
        <source>gain error %1 of sensor %2</source>
        <translation>传感器 %2 的增益误差 %1</translation>
    </message>
    <message>
        <source>offset of Hall sensor A</source>
        <translation>霍尔传感器 A 的偏置</translation>
    </message>
    <message>
        <source>offset of Hall sensor B</source>
        <translation>霍尔传感器 B 的偏置</translation>
    </message>
    <message>
        <source>amplitude of the field</source>
        <translation>磁场幅值</translation>
    </message>
    <message>
        <source>stray field of the coils</source>
        <translation>线圈的杂散磁场</translation>
    </message>
    <message>
        <source>Choose at least one calibration.</source>
        <translation>请至少选择一项标定。</translation>
    </message>
    <message>
        <source>From the project: calibrated in virtual time, device %1.</source>
        <translation>来自项目：在虚拟时间内标定，设备 %1。</translation>
    </message>
    <message>
        <source>From the project: calibrated %1, device %2.</source>
        <translation>来自项目：标定时间 %1，设备 %2。</translation>
    </message>
    <message>
        <source>What is the difference?</source>
        <translation>有何区别？</translation>
    </message>
    <message>
        <source>Still needed most: %1 (%2)</source>
        <translation>最缺的姿态：%1（%2）</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrationFigures</name>
    <message>
        <source>Residual of the ellipse</source>
        <translation>椭圆残差</translation>
    </message>
    <message>
        <source>breakaway current</source>
        <translation>起动电流</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>reverse, sign removed</source>
        <translation>反向，去掉符号</translation>
    </message>
    <message>
        <source>Static friction over the angle</source>
        <translation>静摩擦与角度的关系</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>fitted ellipse</source>
        <translation>拟合椭圆</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
    <message>
        <source>Hall readings and their ellipse</source>
        <translation>霍尔读数及其椭圆</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
    <message>
        <source>reading minus ellipse</source>
        <translation>读数减椭圆</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConfigurationPanel</name>
    <message>
        <source>Lost at power-off. To keep: Parameters &gt; Save to device.</source>
        <translation>断电后丢失。如需保留：参数 &gt; 保存到设备。</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) not restored; see the rows for the cause.</source>
        <translation>
            <numerusform>%n 行未恢复；原因见各行。</numerusform>
        </translation>
    </message>
    <message>
        <source>Previous device settings saved in %1.</source>
        <translation>设备原有设置已保存在 %1。</translation>
    </message>
    <message>
        <source>Write the ticked rows together and read them back. Lost at power-off unless saved to the device</source>
        <translation>一次写入勾选的行并回读。未保存到设备则断电后丢失</translation>
    </message>
    <message>
        <source>Also tick calibration values; they are valid only for the device they were measured on</source>
        <translation>同时勾选标定值；标定值仅对测量时的设备有效</translation>
    </message>
    <message>
        <source>Hide rows that are equal or missing in the file</source>
        <translation>隐藏相同或文件中缺失的行</translation>
    </message>
    <message>
        <source>Only &amp;differences</source>
        <translation>仅差异(&amp;D)</translation>
    </message>
    <message>
        <source>A file is compared with the device row by row. Tick rows to restore them. The present device settings are saved first.</source>
        <translation>逐行比较文件与设备。勾选的行将被恢复。恢复前先保存设备的当前设置。</translation>
    </message>
    <message>
        <source>Compare a file with the device; nothing is written yet</source>
        <translation>将文件与设备比较；尚不写入</translation>
    </message>
    <message>
        <source>Save all device settings to a file</source>
        <translation>将设备的所有设置保存到文件</translation>
    </message>
    <message>
        <source>No configuration file is open</source>
        <translation>没有打开配置文件</translation>
    </message>
    <message>
        <source>With &amp;calibration</source>
        <translation>含标定(&amp;C)</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message numerus="yes">
        <source>Restore %n row(s)</source>
        <translation>
            <numerusform>恢复 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>Save settings</source>
        <translation>保存设置</translation>
    </message>
    <message>
        <source>Configuration (*.toml)</source>
        <translation>配置 (*.toml)</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) saved.</source>
        <translation>
            <numerusform>已保存 %n 项设置。</numerusform>
        </translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>%1: device %2, firmware %3, written %4</source>
        <translation>%1：设备 %2，固件 %3，写于 %4</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) restored and read back.</source>
        <translation>
            <numerusform>已恢复并读回 %n 行。</numerusform>
        </translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>Save settings…</source>
        <translation>保存设置…</translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>Compare with a file…</source>
        <translation>与文件比较…</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConfigurationTable</name>
    <message>
        <source>differs; calibration value, valid for one device only</source>
        <translation>不同；标定值，仅对一台设备有效</translation>
    </message>
    <message>
        <source>Ticked rows are restored (Space). Values in SI units, as in the file</source>
        <translation>勾选的行将被恢复（空格键）。数值为 SI 单位，与文件一致</translation>
    </message>
    <message>
        <source>Rows of the configuration</source>
        <translation>配置的各行</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>restored</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation>文件中没有</translation>
    </message>
    <message>
        <source>not restored</source>
        <translation>未恢复</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒绝</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConnectButton</name>
    <message>
        <source>Stop searching for the device (Ctrl+Shift+C)</source>
        <translation>停止查找设备 (Ctrl+Shift+C)</translation>
    </message>
    <message>
        <source>Stop, disarm and disconnect (Ctrl+Shift+C)</source>
        <translation>停止、解除使能并断开 (Ctrl+Shift+C)</translation>
    </message>
    <message>
        <source>Connect the selected device (Ctrl+Shift+C; list: Alt+Down)</source>
        <translation>连接所选设备（Ctrl+Shift+C；列表：Alt+Down）</translation>
    </message>
    <message>
        <source>Close the recording (Ctrl+Shift+C)</source>
        <translation>关闭记录（Ctrl+Shift+C）</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Close the recording, back to %1 (Ctrl+Shift+C)</source>
        <translation>关闭记录，返回 %1（Ctrl+Shift+C）</translation>
    </message>
</context>
<context>
    <name>halbench::app::DepartureWords</name>
    <message>
        <source>The device was disarmed first and its settings were restored. Start again after reconnecting.</source>
        <translation>已先对设备解除使能并恢复其设置。重新连接后请再次启动。</translation>
    </message>
    <message>
        <source>Stopped: the device was disconnected.</source>
        <translation>已结束：设备已断开。</translation>
    </message>
    <message>
        <source>The device&apos;s watchdog disarms it. Start again after reconnecting.</source>
        <translation>设备的看门狗会解除使能。重新连接后请再次启动。</translation>
    </message>
    <message>
        <source>Stopped: connection to the device lost: %1.</source>
        <translation>已结束：与设备的连接丢失：%1。</translation>
    </message>
</context>
<context>
    <name>halbench::app::DerivedPanel</name>
    <message>
        <source>Remove the selected signal (Delete)</source>
        <translation>删除所选信号 (Delete)</translation>
    </message>
    <message>
        <source>Add the signal; computed from now on (Enter)</source>
        <translation>添加信号；从现在起计算 (Enter)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Unit of the result, e.g. rad, rad/s, T, A, degC; empty: derived from the expression</source>
        <translation>结果的单位，例如 rad、rad/s、T、A、degC；留空：由表达式推出</translation>
    </message>
    <message>
        <source>Name in the signal tree: letters, digits, dots, underscores</source>
        <translation>信号树中的名称：字母、数字、点、下划线</translation>
    </message>
    <message>
        <source>Enter copies a row into the fields above, Delete removes it</source>
        <translation>按 Enter 将该行复制到上方，按 Delete 删除</translation>
    </message>
    <message>
        <source>Error in the expression</source>
        <translation>表达式错误</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>表达式</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Derived signals</source>
        <translation>派生信号</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>waits for a device</source>
        <translation>等待设备</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>已计算</translation>
    </message>
    <message>
        <source>sine of an angle in rad</source>
        <translation>弧度角的正弦</translation>
    </message>
    <message>
        <source>cosine of an angle in rad</source>
        <translation>弧度角的余弦</translation>
    </message>
    <message>
        <source>angle of the point (x, y): atan2(y, x)</source>
        <translation>点 (x, y) 的角度：atan2(y, x)</translation>
    </message>
    <message>
        <source>square root</source>
        <translation>平方根</translation>
    </message>
    <message>
        <source>absolute value</source>
        <translation>绝对值</translation>
    </message>
    <message>
        <source>exponential function</source>
        <translation>指数函数</translation>
    </message>
    <message>
        <source>natural logarithm</source>
        <translation>自然对数</translation>
    </message>
    <message>
        <source>smaller of two values</source>
        <translation>两值中较小者</translation>
    </message>
    <message>
        <source>larger of two values</source>
        <translation>两值中较大者</translation>
    </message>
    <message>
        <source>ratio of circumference to diameter</source>
        <translation>圆周率</translation>
    </message>
    <message>
        <source>Signals in SI units, e.g. current.a^2 (Enter adds it)</source>
        <translation>信号采用国际单位制，如 current.a^2（回车添加）</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>插入</translation>
    </message>
    <message>
        <source>Insert a signal or a function into the expression</source>
        <translation>向表达式插入信号或函数</translation>
    </message>
    <message>
        <source>No derived signals yet. Example: name power, expression current.a^2 + current.b^2.
Type a part of a signal&apos;s name to choose it, or drag it here from the signals.</source>
        <translation>还没有派生信号。示例：名称 power，表达式 current.a^2 + current.b^2。
输入信号名称的一部分进行选择，或从信号列表拖到这里。</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>函数</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignNames</name>
    <message>
        <source>edited manually</source>
        <translation>手动编辑</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>推荐</translation>
    </message>
    <message>
        <source>pole placement</source>
        <translation>极点配置</translation>
    </message>
    <message>
        <source>bandwidth</source>
        <translation>带宽</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>SIMC</source>
        <translation>SIMC</translation>
    </message>
    <message>
        <source>lambda</source>
        <translation>Lambda</translation>
    </message>
    <message>
        <source>Ziegler-Nichols PID</source>
        <translation>Ziegler-Nichols PID</translation>
    </message>
    <message>
        <source>Ziegler-Nichols PI</source>
        <translation>Ziegler-Nichols PI</translation>
    </message>
    <message>
        <source>Ziegler-Nichols P</source>
        <translation>Ziegler-Nichols P</translation>
    </message>
    <message>
        <source>LQR</source>
        <translation>LQR</translation>
    </message>
    <message>
        <source>least IAE</source>
        <translation>最小 IAE</translation>
    </message>
    <message>
        <source>least ITAE</source>
        <translation>最小 ITAE</translation>
    </message>
    <message>
        <source>lead</source>
        <translation>超前 (PD)</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>滞后 (PI)</translation>
    </message>
    <message>
        <source>published</source>
        <translation>已发表</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>设计值</translation>
    </message>
    <message>
        <source>micro-step</source>
        <translation>微步</translation>
    </message>
    <message>
        <source>published, in degrees</source>
        <translation>已发表，按度</translation>
    </message>
    <message>
        <source>from the device</source>
        <translation>来自设备</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignTable</name>
    <message>
        <source>Redo the last undone change (Ctrl+Shift+Z)</source>
        <translation>重做最近撤销的更改（Ctrl+Shift+Z）</translation>
    </message>
    <message>
        <source>Undo the last change of the list (Ctrl+Z)</source>
        <translation>撤销对列表的最近更改（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Remove the selected design from the project</source>
        <translation>从项目中移除所选设计</translation>
    </message>
    <message>
        <source>Use the gains of the selected design as proposed gains</source>
        <translation>将所选设计的增益用作建议增益</translation>
    </message>
    <message>
        <source>Use this design</source>
        <translation>使用此设计</translation>
    </message>
    <message>
        <source>Save the proposed gains in the project under a name</source>
        <translation>将建议的增益以名称保存在项目中</translation>
    </message>
    <message>
        <source>Save design</source>
        <translation>保存设计</translation>
    </message>
    <message>
        <source>A tick shows the design in the plots (Space), F2 renames it, Del removes it</source>
        <translation>勾选后在图中显示该设计（空格），F2 重命名，Del 移除</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>UNSTABLE</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>当前建议</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>Delay margin</source>
        <translation>时延裕度</translation>
    </message>
    <message>
        <source>Bandwidth</source>
        <translation>带宽</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>闭环</translation>
    </message>
    <message>
        <source>Designs compared</source>
        <translation>设计比较</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>%1, with filters</source>
        <translation>%1，带滤波</translation>
    </message>
</context>
<context>
    <name>halbench::app::DevicePanel</name>
    <message>
        <source>A2L file from the manufacturer, for boards without a built-in description</source>
        <translation>制造商提供的 A2L 文件，用于不自带描述的控制板</translation>
    </message>
    <message>
        <source>not specified</source>
        <translation>未指定</translation>
    </message>
    <message>
        <source>Stop searching for the device (Alt+C)</source>
        <translation>停止查找设备 (Alt+C)</translation>
    </message>
    <message>
        <source>Stop, disarm and disconnect (Alt+C)</source>
        <translation>停止、解除使能并断开 (Alt+C)</translation>
    </message>
    <message>
        <source>Choose one from the list or enter its address.</source>
        <translation>请从列表中选择，或输入地址。</translation>
    </message>
    <message>
        <source>No device selected.</source>
        <translation>未选择设备。</translation>
    </message>
    <message>
        <source>Model, identity and firmware reported by the device</source>
        <translation>设备报告的型号、标识和固件</translation>
    </message>
    <message>
        <source>Device identification</source>
        <translation>设备标识</translation>
    </message>
    <message>
        <source>Example: sim:htm?seed=7 or tcp:HOST:PORT</source>
        <translation>示例：sim:htm?seed=7 或 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>Enter or double-click connects</source>
        <translation>按回车键或双击连接</translation>
    </message>
    <message>
        <source>Available devices</source>
        <translation>可用设备</translation>
    </message>
    <message>
        <source>Device address</source>
        <translation>设备地址</translation>
    </message>
    <message>
        <source>sim:htm or tcp:HOST:PORT</source>
        <translation>sim:htm 或 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>Dis&amp;connect</source>
        <translation>断开(&amp;C)</translation>
    </message>
    <message>
        <source>Connect the device (Alt+C)</source>
        <translation>连接设备 (Alt+C)</translation>
    </message>
    <message>
        <source>%1
Firmware %2</source>
        <translation>%1
固件 %2</translation>
    </message>
    <message>
        <source>%1, last used</source>
        <translation>%1，上次使用</translation>
    </message>
    <message>
        <source>Description of the board</source>
        <translation>控制板描述</translation>
    </message>
    <message>
        <source>Description (*.a2l)</source>
        <translation>描述 (*.a2l)</translation>
    </message>
    <message>
        <source>Description file…</source>
        <translation>描述文件…</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>返回(&amp;B)</translation>
    </message>
    <message>
        <source>Close the recording, back to %1 (Alt+B)</source>
        <translation>关闭记录，返回 %1（Alt+B）</translation>
    </message>
    <message>
        <source>Stopping and disarming…</source>
        <translation>正在停止并解除使能…</translation>
    </message>
    <message>
        <source>Connection lost. Reconnecting to %1…</source>
        <translation>连接丢失。正在重新连接 %1…</translation>
    </message>
    <message>
        <source>Simulation options…</source>
        <translation>仿真选项…</translation>
    </message>
    <message>
        <source>Values of the simulated actuator: motion, noise, faults…</source>
        <translation>仿真执行器的数值：运动、噪声、故障…</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>No device found on USB or a serial port.</source>
        <translation>USB 和串口上未发现设备。</translation>
    </message>
    <message>
        <source>%1, simulated (%2)</source>
        <translation>%1，仿真（%2）</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Copy address</source>
        <translation>复制地址</translation>
    </message>
</context>
<context>
    <name>halbench::app::DeviceSession</name>
    <message>
        <source>armed: will be disarmed before disconnecting</source>
        <translation>已使能：断开前先解除使能</translation>
    </message>
    <message numerus="yes">
        <source>%Ln sample(s) not shown: rate too high for the window</source>
        <translation>
            <numerusform>%Ln 个样本未显示：速率对窗口而言过高</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reconnected after %2 s, disarmed</source>
        <translation>%1 在 %2 s 后重新连接，未使能</translation>
    </message>
    <message>
        <source>%1 more messages not shown (too many at once)</source>
        <translation>另有 %1 条消息未显示（数量过多）</translation>
    </message>
    <message>
        <source>Window not responding while armed: actuator stopped</source>
        <translation>使能状态下窗口无响应：执行器已停止</translation>
    </message>
    <message>
        <source>board</source>
        <translation>控制板</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>connecting %1</source>
        <translation>正在连接 %1</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>已断开</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>connected %1, firmware %2</source>
        <translation>已连接 %1，固件 %2</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>back to %1</source>
        <translation>返回 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::DisplayQuantity</name>
    <message>
        <source>Inconsistent parameter sets</source>
        <translation>不一致的参数组</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>转矩</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>r/min</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>field</source>
        <translation>磁场</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>current slope</source>
        <translation>电流变化率</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Current command</source>
        <translation>电流指令</translation>
    </message>
    <message>
        <source>Current A</source>
        <translation>电流 A</translation>
    </message>
    <message>
        <source>Current B</source>
        <translation>电流 B</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
    <message>
        <source>Coil A</source>
        <translation>线圈 A</translation>
    </message>
    <message>
        <source>Coil B</source>
        <translation>线圈 B</translation>
    </message>
    <message>
        <source>Board state</source>
        <translation>控制板状态</translation>
    </message>
    <message>
        <source>Fault code</source>
        <translation>故障代码</translation>
    </message>
    <message>
        <source>Generator segment</source>
        <translation>发生器段号</translation>
    </message>
    <message>
        <source>Generator running</source>
        <translation>发生器运行中</translation>
    </message>
    <message>
        <source>Capture state</source>
        <translation>捕获状态</translation>
    </message>
    <message>
        <source>Capture time</source>
        <translation>捕获时间</translation>
    </message>
    <message>
        <source>True angle</source>
        <translation>真实角度</translation>
    </message>
    <message>
        <source>True speed</source>
        <translation>真实转速</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>比值</translation>
    </message>
    <message>
        <source>rev</source>
        <translation>r</translation>
    </message>
    <message>
        <source>rev/s</source>
        <translation>r/s</translation>
    </message>
    <message>
        <source>Lift force</source>
        <translation>升力</translation>
    </message>
    <message>
        <source>Chi-square</source>
        <translation>卡方</translation>
    </message>
    <message>
        <source>Squared innovation</source>
        <translation>新息平方</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>电流缩放</translation>
    </message>
    <message>
        <source>Cell x</source>
        <translation>单元 x</translation>
    </message>
    <message>
        <source>Cell y</source>
        <translation>单元 y</translation>
    </message>
    <message>
        <source>Sensors left out</source>
        <translation>未用传感器</translation>
    </message>
    <message>
        <source>Channels left out</source>
        <translation>未用通道</translation>
    </message>
    <message>
        <source>Homed</source>
        <translation>已回零</translation>
    </message>
    <message>
        <source>Field strength</source>
        <translation>磁场强度</translation>
    </message>
    <message>
        <source>Expected field strength</source>
        <translation>预期磁场强度</translation>
    </message>
    <message>
        <source>Shaft cone (95 %)</source>
        <translation>轴锥角(95 %)</translation>
    </message>
    <message>
        <source>Orientation state</source>
        <translation>姿态状态</translation>
    </message>
    <message>
        <source>Integrity code</source>
        <translation>完整性代码</translation>
    </message>
    <message>
        <source>Coil current</source>
        <translation>线圈电流</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>True field strength</source>
        <translation>真实磁场强度</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>位置 %1</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>速度 %1</translation>
    </message>
    <message>
        <source>Reference %1</source>
        <translation>参考 %1</translation>
    </message>
    <message>
        <source>Command %1</source>
        <translation>指令 %1</translation>
    </message>
    <message>
        <source>Effort %1</source>
        <translation>作用量 %1</translation>
    </message>
    <message>
        <source>True position %1</source>
        <translation>真实位置 %1</translation>
    </message>
    <message>
        <source>True speed %1</source>
        <translation>真实速度 %1</translation>
    </message>
    <message>
        <source>True effort %1</source>
        <translation>真实作用量 %1</translation>
    </message>
    <message>
        <source>Orientation %1</source>
        <translation>姿态 %1</translation>
    </message>
    <message>
        <source>Shaft %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>True rate %1</source>
        <translation>真实角速率 %1</translation>
    </message>
    <message>
        <source>True orientation %1</source>
        <translation>真实姿态 %1</translation>
    </message>
    <message>
        <source>Hall %1</source>
        <translation>霍尔 %1</translation>
    </message>
    <message>
        <source>Current %1</source>
        <translation>电流 %1</translation>
    </message>
    <message>
        <source>Coil %1</source>
        <translation>线圈 %1</translation>
    </message>
    <message>
        <source>Field %1</source>
        <translation>磁场 %1</translation>
    </message>
    <message>
        <source>Residual %1</source>
        <translation>残差 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::DockLayout</name>
    <message>
        <source>Show or hide this panel (%1)</source>
        <translation>显示或隐藏此面板 (%1)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DockMenu</name>
    <message>
        <source>P&amp;anel layout “%1”</source>
        <translation>面板布局“%1”(&amp;A)</translation>
    </message>
    <message>
        <source>P&amp;anel layout</source>
        <translation>面板布局(&amp;A)</translation>
    </message>
    <message>
        <source>Change the panel&apos;s size; neighbouring panels adjust</source>
        <translation>改变面板大小；相邻面板随之调整</translation>
    </message>
    <message>
        <source>Move the panel to the next place on that side or edge</source>
        <translation>将面板移到该侧的下一个位置</translation>
    </message>
    <message>
        <source>Move the panel to its own window with STOP, or dock it again</source>
        <translation>将面板移到带停止按钮的单独窗口，或重新停靠</translation>
    </message>
    <message>
        <source>Brings the tab beside it to the front, with the focus</source>
        <translation>把旁边的标签页移到前面并获得焦点</translation>
    </message>
    <message>
        <source>&amp;Previous tab</source>
        <translation>上一个标签页(&amp;P)</translation>
    </message>
    <message>
        <source>Ne&amp;xt tab</source>
        <translation>下一个标签页(&amp;X)</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>左移(&amp;L)</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>右移(&amp;R)</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>上移(&amp;U)</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>下移(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>加宽(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>变窄(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Taller</source>
        <translation>加高(&amp;T)</translation>
    </message>
    <message>
        <source>Dock it &amp;back</source>
        <translation>放回(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Float in its own window</source>
        <translation>浮动为单独的窗口(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Shorter</source>
        <translation>变矮(&amp;S)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DocumentFiles</name>
    <message>
        <source>Plotted data (*.csv)</source>
        <translation>图中的数据 (*.csv)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Picture (*.svg *.pdf *.png)</source>
        <translation>图片 (*.svg *.pdf *.png)</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReferenceRun</name>
    <message>
        <source>Disarm and arm, then start. Firmware 0.2.0 and later starts at the present position.</source>
        <translation>请先解除使能再使能，然后启动。0.2.0 及以后的固件从当前位置开始。</translation>
    </message>
    <message>
        <source>Not started: with this firmware (%1) the motion would begin at the arming position and the rotor would jump.</source>
        <translation>未启动：此固件 (%1) 会从使能位置开始运动，转子会突跳。</translation>
    </message>
</context>
<context>
    <name>halbench::app::SetpointMotion</name>
    <message>
        <source>Not sent: a step above %1 is too large, and this firmware has no ramp.</source>
        <translation>未发送：超过 %1 的阶跃过大，且此固件没有斜坡功能。</translation>
    </message>
    <message>
        <source>Not sent: a reference is running, and a step above %1 is too large.</source>
        <translation>未发送：参考信号正在运行，超过 %1 的阶跃过大。</translation>
    </message>
    <message>
        <source>Use smaller steps or jog. Firmware 0.2.0 and later moves in a ramp.</source>
        <translation>请用较小的步长或点动。0.2.0 及以后的固件以斜坡移动。</translation>
    </message>
    <message>
        <source>End the reference first. The device then moves there in a ramp.</source>
        <translation>请先结束参考信号。之后设备以斜坡移动到该处。</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveLimits</name>
    <message>
        <source>Enter writes it. Lost at power-off unless saved to the device</source>
        <translation>按 Enter 写入。未保存到设备则断电后丢失</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid limit. Nothing was written.</source>
        <translation>“%1”不是有效限值。未写入任何内容。</translation>
    </message>
    <message>
        <source>Off: not monitored (Space)</source>
        <translation>关：不监控（空格键）</translation>
    </message>
    <message>
        <source>Device stops above this speed</source>
        <translation>超过此转速时设备停止</translation>
    </message>
    <message>
        <source>Device stops at this distance from the arming position</source>
        <translation>离使能位置达到此距离时设备停止</translation>
    </message>
    <message>
        <source>Device stops when a coil is hotter</source>
        <translation>任一线圈超过此温度时设备停止</translation>
    </message>
    <message>
        <source>Hottest coil</source>
        <translation>最热线圈</translation>
    </message>
    <message>
        <source>Maximum current. A larger command in current mode stops the device</source>
        <translation>最大电流。电流模式下指令超过此值时设备停止</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>%1的限值</translation>
    </message>
</context>
<context>
    <name>halbench::app::DrivePanel</name>
    <message>
        <source>Lost at power-off. To keep: Parameters &gt; Save to device.</source>
        <translation>断电后丢失。如需保留：参数 &gt; 保存到设备。</translation>
    </message>
    <message>
        <source>Start the reference from the present set-point; repeated starts
add up (Ctrl+Shift+R)</source>
        <translation>从当前设定值启动参考信号；重复启动
会累加 (Ctrl+Shift+R)</translation>
    </message>
    <message>
        <source>Send the set-point (Enter in the field). Long moves
are ramps at jog speed.</source>
        <translation>发送设定值（在输入框中按回车）。长行程
以点动速度按斜坡完成。</translation>
    </message>
    <message>
        <source>Axis for set-point, jog and reference; other axes hold (Alt+X)</source>
        <translation>设定值、点动和参考信号所作用的轴；其余轴保持 (Alt+X)</translation>
    </message>
    <message>
        <source>Without the offset from a finished reference (Enter sends it)</source>
        <translation>不含已结束参考信号产生的偏移（按 Enter 发送）</translation>
    </message>
    <message>
        <source>Waiting for the first angle sample.</source>
        <translation>等待第一个角度采样值。</translation>
    </message>
    <message>
        <source>Send set-point zero: move back by %1 at jog speed</source>
        <translation>发送零设定值：以点动速度返回 %1</translation>
    </message>
    <message>
        <source>Send set-point zero: step back by %1</source>
        <translation>发送零设定值：跳回 %1</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Armed: %1</source>
        <translation>已使能：%1</translation>
    </message>
    <message>
        <source>Allowed now: %1 to %2. Widen the window, or disarm and arm to set a new zero.</source>
        <translation>当前允许：%1 至 %2。请放宽窗口，或解除使能后再使能以重置零点。</translation>
    </message>
    <message>
        <source>%1 is outside the excursion window. Nothing was sent.</source>
        <translation>%1 超出偏移窗口。未发送任何内容。</translation>
    </message>
    <message>
        <source>Stopped while disarmed</source>
        <translation>未使能时收到停止</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid set-point. Nothing was sent.</source>
        <translation>“%1”不是有效设定值。未发送任何内容。</translation>
    </message>
    <message>
        <source>Above the limit: the device may stop.</source>
        <translation>超出限值：设备可能停止。</translation>
    </message>
    <message>
        <source>Range: up to %1.</source>
        <translation>范围：最大 %1。</translation>
    </message>
    <message>
        <source>Device limits</source>
        <translation>设备限值</translation>
    </message>
    <message>
        <source>End the reference: position is held, current goes to 0 (Ctrl+Shift+E)</source>
        <translation>结束参考信号：位置保持，电流归零 (Ctrl+Shift+E)</translation>
    </message>
    <message>
        <source>Send set-point zero</source>
        <translation>发送零设定值</translation>
    </message>
    <message>
        <source>State reported by the device</source>
        <translation>设备报告的状态</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>模式(&amp;M)</translation>
    </message>
    <message>
        <source>Set-point and jog</source>
        <translation>设定值与点动</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>执行</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>归零</translation>
    </message>
    <message>
        <source>Reference generator</source>
        <translation>参考信号发生器</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>%1 is running</source>
        <translation>%1正在运行</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>状态：%1</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Current (Enter sends it)</source>
        <translation>电流（按回车键发送）</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>A&amp;xis</source>
        <translation>轴(&amp;X)</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source> (%1)</source>
        <translation>（%1）</translation>
    </message>
    <message>
        <source>Position relative to the arming position</source>
        <translation>相对于使能位置的位置</translation>
    </message>
    <message>
        <source>Position relative to the mode&apos;s start</source>
        <translation>相对于进入该模式时的位置</translation>
    </message>
    <message>
        <source>Set-point %1</source>
        <translation>设定值 %1</translation>
    </message>
    <message>
        <source>Arm to move. Set-points start at 0.</source>
        <translation>使能后才能运动。设定值从 0 开始。</translation>
    </message>
    <message>
        <source>Set-point %1 + jog or reference %2</source>
        <translation>设定值 %1 + 点动或参考 %2</translation>
    </message>
    <message>
        <source>Travel: up to %1 from here.</source>
        <translation>行程：距此处最多 %1。</translation>
    </message>
    <message>
        <source>Travel: up to %1 from here, up to %2 from the arming position.</source>
        <translation>行程：距此处最多 %1，距使能位置最多 %2。</translation>
    </message>
    <message>
        <source>A motion is running. End it to start another.</source>
        <translation>正在运动。先结束它，再开始新的运动。</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>解除</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveWords</name>
    <message>
        <source>%1, %2 mode</source>
        <translation>%1，%2模式</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考信号</translation>
    </message>
    <message>
        <source>step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>multisine</source>
        <translation>多正弦</translation>
    </message>
    <message>
        <source>plateaus</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>d-axis</source>
        <translation>D 轴</translation>
    </message>
    <message>
        <source>jogging</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>梯形</translation>
    </message>
    <message>
        <source>s-curve</source>
        <translation>S 曲线</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>raster</source>
        <translation>栅格</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>table of poses</source>
        <translation>位姿表</translation>
    </message>
</context>
<context>
    <name>halbench::app::FaultWords</name>
    <message>
        <source>Check the board&apos;s cables and supply, then release the stop.</source>
        <translation>请检查控制板的电缆和电源，然后解除停止。</translation>
    </message>
    <message>
        <source>Output converter of a coil not responding</source>
        <translation>线圈的输出转换器无响应</translation>
    </message>
    <message>
        <source>Write proven gains.</source>
        <translation>请写入已验证的增益。</translation>
    </message>
    <message>
        <source>Controller output is not a number</source>
        <translation>控制器输出为非数值</translation>
    </message>
    <message>
        <source>Check the sensors and their connector, then calibrate the Hall sensors.</source>
        <translation>请检查传感器和插头，然后标定霍尔传感器。</translation>
    </message>
    <message>
        <source>Hall sensor out of range</source>
        <translation>霍尔传感器超出范围</translation>
    </message>
    <message>
        <source>Turn more slowly. Check for magnets or iron near the Hall sensors.</source>
        <translation>请放慢转速。检查霍尔传感器附近是否有磁体或铁件。</translation>
    </message>
    <message>
        <source>Use a smaller motion, or widen the excursion window.</source>
        <translation>请减小运动幅度，或放宽偏移窗口。</translation>
    </message>
    <message>
        <source>Position outside its window</source>
        <translation>位置超出窗口</translation>
    </message>
    <message>
        <source>Use less current or a slower reference, or widen the speed window.</source>
        <translation>请减小电流或放慢参考信号，或放宽转速窗口。</translation>
    </message>
    <message>
        <source>Speed above its limit</source>
        <translation>转速超过限值</translation>
    </message>
    <message>
        <source>Current command above the limit</source>
        <translation>电流指令超过限值</translation>
    </message>
    <message>
        <source>Let the coils cool. Use less current or add pauses.</source>
        <translation>请让线圈冷却。减小电流或增加间歇。</translation>
    </message>
    <message>
        <source>Coil temperature above its limit</source>
        <translation>线圈温度超过限值</translation>
    </message>
    <message>
        <source>Release the stop, then arm, to move again.</source>
        <translation>如需再次运动，请先解除停止，再使能。</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Use a smaller set-point or amplitude.</source>
        <translation>请减小设定值或幅值。</translation>
    </message>
    <message>
        <source>The measured angle jumped</source>
        <translation>测得的角度发生跳变</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>由命令</translation>
    </message>
    <message>
        <source>by the watchdog</source>
        <translation>由看门狗</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>已停止：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::FieldPanel</name>
    <message>
        <source>This device has no signals that a picture could be made of.</source>
        <translation>此设备没有可用于生成图像的信号。</translation>
    </message>
    <message>
        <source>Shows the rotor or platen of a connected actuator, with its field.</source>
        <translation>显示已连接执行器的转子或动子及其磁场。</translation>
    </message>
    <message>
        <source>Save as SVG, PDF or PNG (Alt+P)</source>
        <translation>保存为 SVG、PDF 或 PNG (Alt+P)</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>保存图片(&amp;P)…</translation>
    </message>
</context>
<context>
    <name>halbench::app::FilterEditor</name>
    <message>
        <source>Time constant; 0: difference of two samples</source>
        <translation>时间常数；0：两个采样值之差</translation>
    </message>
    <message>
        <source>Weight on K_D: 0 ignores a set-point step, 1 passes all of it</source>
        <translation>K_D 的权重：0 忽略设定值阶跃，1 完全作用</translation>
    </message>
    <message>
        <source>Set-point weights, derivative filter and series filters</source>
        <translation>设定值权重、微分滤波和串联滤波器</translation>
    </message>
    <message>
        <source>Lead: adds phase at a frequency. Lag: raises the DC gain. Notch: lowers the gain at a frequency. Low-pass: lowers the gain above a frequency. Section: second order by coefficients</source>
        <translation>超前：在某一频率增加相位。滞后：提高直流增益。陷波：降低某一频率的增益。低通：降低某一频率以上的增益。二阶节：由系数给出</translation>
    </message>
    <message>
        <source>Coefficient of d in the denominator; 0: no dynamics</source>
        <translation>分母中 d 的系数；0：无动态</translation>
    </message>
    <message>
        <source>Frequency of −3 dB</source>
        <translation>−3 dB 频率</translation>
    </message>
    <message>
        <source>Damping of the poles: larger is wider</source>
        <translation>极点阻尼：越大越宽</translation>
    </message>
    <message>
        <source>Gain factor at this frequency, 0 to 1</source>
        <translation>该频率处的增益倍数，0 到 1</translation>
    </message>
    <message>
        <source>Frequency of minimum gain</source>
        <translation>增益最小的频率</translation>
    </message>
    <message>
        <source>Factor on the DC gain, above 1</source>
        <translation>直流增益的倍数，大于 1</translation>
    </message>
    <message>
        <source>Gain is unchanged far above this frequency</source>
        <translation>远高于该频率时增益不变</translation>
    </message>
    <message>
        <source>Phase added at this frequency</source>
        <translation>该频率处增加的相位</translation>
    </message>
    <message>
        <source>Frequency of the added phase; the gain there is unchanged</source>
        <translation>增加相位的频率；该处增益不变</translation>
    </message>
    <message>
        <source>Derivative filter time</source>
        <translation>微分滤波时间</translation>
    </message>
    <message>
        <source>Set-point weight c (D)</source>
        <translation>设定值权重 c (D)</translation>
    </message>
    <message>
        <source>Weight on K_P: below 1 gives a softer set-point step</source>
        <translation>K_P 的权重：小于 1 时设定值阶跃更平缓</translation>
    </message>
    <message>
        <source>Set-point weight b (P)</source>
        <translation>设定值权重 b (P)</translation>
    </message>
    <message>
        <source>In series with the others, four at most; low-pass first</source>
        <translation>与其他滤波器串联，最多四个；默认低通</translation>
    </message>
    <message>
        <source>DC gain</source>
        <translation>直流增益</translation>
    </message>
    <message>
        <source>Enter a number within the range</source>
        <translation>请输入范围内的数值</translation>
    </message>
    <message>
        <source>missing number</source>
        <translation>缺少数值</translation>
    </message>
    <message>
        <source>Type of filter %1</source>
        <translation>滤波器 %1 的类型</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>编辑 %1</translation>
    </message>
    <message>
        <source>Add a filter</source>
        <translation>添加滤波器</translation>
    </message>
    <message>
        <source>Remove a filter</source>
        <translation>移除滤波器</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>超前</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>滞后</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>陷波</translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation>低通</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>转折频率</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>阶数</translation>
    </message>
    <message>
        <source>Filter %1</source>
        <translation>滤波器 %1</translation>
    </message>
    <message>
        <source>%1: kind</source>
        <translation>%1：类型</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除%1</translation>
    </message>
    <message>
        <source>Weights and filters</source>
        <translation>权重与滤波器</translation>
    </message>
    <message>
        <source>1 or 2</source>
        <translation>1 或 2</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>二阶节</translation>
    </message>
    <message>
        <source>Coefficient of (b0 d² + b1 d + b2)/(d² + a1 d + a2), d = z − 1</source>
        <translation>(b0 d² + b1 d + b2)/(d² + a1 d + a2) 的系数，d = z − 1</translation>
    </message>
    <message>
        <source>Coefficient of d in the numerator</source>
        <translation>分子中 d 的系数</translation>
    </message>
    <message>
        <source>Coefficient of 1 in the numerator</source>
        <translation>分子中的常数项</translation>
    </message>
    <message>
        <source>Coefficient of 1 in the denominator</source>
        <translation>分母中的常数项</translation>
    </message>
    <message>
        <source>For analysis and C export. A connected device may run them as well.</source>
        <translation>用于分析和 C 代码导出。连接的设备也可能运行它们。</translation>
    </message>
    <message>
        <source>This device runs them, with up to %1 filters.</source>
        <translation>该设备可运行它们，最多 %1 个滤波器。</translation>
    </message>
    <message>
        <source>This device runs a part of them; the others are for analysis and C export only.</source>
        <translation>该设备可运行其中一部分；其余仅用于分析和 C 代码导出。</translation>
    </message>
    <message>
        <source>This device does not run them: for analysis and C export only.</source>
        <translation>该设备不运行它们：仅用于分析和 C 代码导出。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ForeignMotorNotice</name>
    <message>
        <source>Motor that the gains are designed for</source>
        <translation>增益所针对的电机</translation>
    </message>
    <message>
        <source>The gains were designed for a motor that may differ from this one</source>
        <translation>这些增益是为可能不同的电机设计的</translation>
    </message>
    <message>
        <source>Apply the gains of another motor</source>
        <translation>应用另一台电机的增益</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyFigures</name>
    <message>
        <source>Excitation as recorded</source>
        <translation>记录的激励</translation>
    </message>
    <message>
        <source>fitted rotor</source>
        <translation>拟合的转子</translation>
    </message>
    <message>
        <source>95 % region</source>
        <translation>95 % 区域</translation>
    </message>
    <message>
        <source>measured, low coherence</source>
        <translation>实测，相干性低</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>Measured open loop</source>
        <translation>实测开环</translation>
    </message>
    <message>
        <source>Measured plant: angle over current, rad/A</source>
        <translation>实测对象：角度/电流，rad/A</translation>
    </message>
    <message>
        <source>Measured closed loop</source>
        <translation>实测闭环</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>相干性</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>reference speed</source>
        <translation>参考转速</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>电流幅值</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyForm</name>
    <message>
        <source>Minimum coherence</source>
        <translation>最小相干性</translation>
    </message>
    <message>
        <source>Enter the number again</source>
        <translation>请重新输入该数</translation>
    </message>
    <message>
        <source>maximum safe value</source>
        <translation>最大安全值</translation>
    </message>
    <message>
        <source>Amplitude of a sine of the same rms in each band. Empty: maximum safe value</source>
        <translation>各频带内等有效值正弦的幅值。留空：最大安全值</translation>
    </message>
    <message>
        <source>Points below it are shown faint and not used for margins and fit</source>
        <translation>低于此值的点淡显，不用于裕度和拟合</translation>
    </message>
    <message>
        <source>Periods (chirp: sweeps) to average; the intervals shrink with the square root</source>
        <translation>平均的周期数（扫频：扫描次数）；区间随其平方根缩小</translation>
    </message>
    <message>
        <source>Steady speed, at least 3 rad/s in either direction, so that friction acts as a constant offset</source>
        <translation>匀速转速，任一方向至少 3 rad/s，使摩擦成为恒定偏置</translation>
    </message>
    <message>
        <source>At most 45 % of the position loop&apos;s sampling rate</source>
        <translation>至多为位置环采样率的 45 %</translation>
    </message>
    <message>
        <source>One excitation period lasts four periods of this frequency</source>
        <translation>激励的一个周期等于该频率的四个周期</translation>
    </message>
    <message>
        <source>Signal added to the steady motion</source>
        <translation>叠加在匀速运动上的信号</translation>
    </message>
    <message>
        <source>chirp: repeated sweeps</source>
        <translation>扫频：重复扫描</translation>
    </message>
    <message>
        <source>stepped sine: one frequency at a time</source>
        <translation>步进正弦：逐个频率</translation>
    </message>
    <message>
        <source>multisine: all frequencies together</source>
        <translation>多正弦：所有频率同时</translation>
    </message>
    <message>
        <source>E&amp;xcitation</source>
        <translation>激励(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Base speed</source>
        <translation>基础转速(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Periods</source>
        <translation>周期数(&amp;P)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Lowest frequency</source>
        <translation>最低频率</translation>
    </message>
    <message>
        <source>Highest frequency</source>
        <translation>最高频率</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>幅值</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyPanel</name>
    <message>
        <source>Measurement cancelled. Nothing was changed.</source>
        <translation>测量已取消。未更改任何内容。</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>返回设置；此结果保留到下一次运行</translation>
    </message>
    <message>
        <source>Save the points with error and coherence as CSV</source>
        <translation>将各点连同误差和相干性保存为 CSV</translation>
    </message>
    <message>
        <source>Save a file for Tune and the command line</source>
        <translation>保存供整定和命令行使用的文件</translation>
    </message>
    <message>
        <source>Show the measured points in the open loop of Tune, with the proposed gains</source>
        <translation>在整定的开环图中显示实测点，采用建议的增益</translation>
    </message>
    <message>
        <source>The rotor turns steadily and is excited. STOP (Esc) and Cancel end the run. Mode, windows and generator are restored; the gains are not changed.</source>
        <translation>转子匀速转动并受到激励。“停止”（Esc）和“取消”结束测量。模式、窗口和发生器会恢复；增益不变。</translation>
    </message>
    <message>
        <source>Measures the loop with the device&apos;s gains over frequency: open loop, plant and margins with 95 % intervals, during a steady motion in one direction.</source>
        <translation>用设备的增益逐频率测量回路：开环、被控对象以及带 95 % 区间的裕度，测量时沿一个方向匀速运动。</translation>
    </message>
    <message>
        <source>Save response</source>
        <translation>保存响应</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>频率响应 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Excite</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Start measurement</source>
        <translation>开始测量</translation>
    </message>
    <message>
        <source>The rotor turns (Ctrl+Return); Esc stops it</source>
        <translation>转子会转动 (Ctrl+Return)；按 Esc 键停止</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>用于整定</translation>
    </message>
    <message>
        <source>Save response…</source>
        <translation>保存响应…</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Computing the response</source>
        <translation>正在计算频率响应</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyResultView</name>
    <message>
        <source>From current to measured angle, with the fitted rotor</source>
        <translation>从电流到实测角度，含拟合的转子</translation>
    </message>
    <message>
        <source>With the device&apos;s gains: magnitude, phase and coherence over frequency</source>
        <translation>采用设备的增益：幅值、相位和相干性与频率的关系</translation>
    </message>
    <message>
        <source>Margins and fitted rotor</source>
        <translation>裕度与拟合的转子</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>开环</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>被控对象</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>闭环</translation>
    </message>
    <message>
        <source>From the reference to the measured angle</source>
        <translation>从参考到实测角度</translation>
    </message>
    <message>
        <source>Raw record</source>
        <translation>原始记录</translation>
    </message>
    <message>
        <source>Speed and current over time, as recorded</source>
        <translation>记录的转速和电流随时间的变化</translation>
    </message>
    <message>
        <source>Pictures of the frequency response</source>
        <translation>频率响应的图形</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyWords</name>
    <message>
        <source>Maximum current %1 A, maximum coil temperature %2 °C.</source>
        <translation>最大电流 %1 A，最高线圈温度 %2 °C。</translation>
    </message>
    <message>
        <source>Minimum speed during excitation: %1 rad/s.</source>
        <translation>激励期间的最低转速：%1 rad/s。</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies have a coherence of at least %3. The others are shown faint and not used for margins and fit.</source>
        <translation>%2 个频率中有 %1 个的相干性不低于 %3。其余淡显，不用于裕度和拟合。</translation>
    </message>
    <message>
        <source>direct feed-through from current to angle</source>
        <translation>电流到角度的直通量</translation>
    </message>
    <message>
        <source>Device stops at %1 rad/s. The loop is measured with the device&apos;s gains, which are not changed; all other settings are restored.</source>
        <translation>转速达到 %1 rad/s 时设备停止。采用设备的增益测量且不更改增益；其余设置均会恢复。</translation>
    </message>
    <message>
        <source>An excitation of up to %1° is added. The speed keeps its sign; the run stops if it comes near zero.</source>
        <translation>叠加至多 %1° 的激励。转速不变号；接近零时运行停止。</translation>
    </message>
    <message>
        <source>at the crossover of %1 Hz</source>
        <translation>在 %1 Hz 的穿越处</translation>
    </message>
    <message>
        <source>See the findings above for cause and remedy</source>
        <translation>原因和措施见上方的诊断</translation>
    </message>
    <message>
        <source>not given: too uncertain</source>
        <translation>未给出：不确定度过大</translation>
    </message>
    <message>
        <source>not given: crossover in a gap</source>
        <translation>未给出：穿越位于空缺处</translation>
    </message>
    <message>
        <source>not given: no crossover</source>
        <translation>未给出：无穿越</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>%1 to %2 Hz: amplitude %3°</source>
        <translation>%1 至 %2 Hz：幅值 %3°</translation>
    </message>
</context>
<context>
    <name>halbench::app::Freshness</name>
    <message>
        <source>No new values since %1</source>
        <translation>自 %1 起没有新值</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainEditor</name>
    <message>
        <source>Parallel: K_P + K_I/s + K_D s. Standard: K (1 + 1/(T_i s) + T_d s). Series: K (1 + 1/(T_i s))(1 + T_d s). Device and files use the parallel form</source>
        <translation>并联：K_P + K_I/s + K_D s。标准：K (1 + 1/(T_i s) + T_d s)。串联：K (1 + 1/(T_i s))(1 + T_d s)。设备和文件使用并联形式</translation>
    </message>
    <message>
        <source>Show the feed-forward gains</source>
        <translation>显示前馈增益</translation>
    </message>
    <message>
        <source>1 A/° = 57.3 A/rad. Files and device use A/rad</source>
        <translation>1 A/° = 57.3 A/rad。文件和设备使用 A/rad</translation>
    </message>
    <message>
        <source>%1 of the device</source>
        <translation>设备的 %1</translation>
    </message>
    <message>
        <source>Enter zero or a positive number</source>
        <translation>请输入零或正数</translation>
    </message>
    <message>
        <source>missing number</source>
        <translation>缺少数值</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Proportional K_P</source>
        <translation>比例 K_P</translation>
    </message>
    <message>
        <source>Integral K_I</source>
        <translation>积分 K_I</translation>
    </message>
    <message>
        <source>Derivative K_D</source>
        <translation>微分 K_D</translation>
    </message>
    <message>
        <source>Feed-forward of inertia</source>
        <translation>惯量前馈</translation>
    </message>
    <message>
        <source>Feed-forward of damping</source>
        <translation>阻尼前馈</translation>
    </message>
    <message>
        <source>Feed-forward of friction</source>
        <translation>摩擦前馈</translation>
    </message>
    <message>
        <source>Friction assist</source>
        <translation>摩擦补偿</translation>
    </message>
    <message>
        <source>Unit of the gains</source>
        <translation>增益的单位</translation>
    </message>
    <message>
        <source>Feed-forward and friction assist</source>
        <translation>前馈与摩擦补偿</translation>
    </message>
    <message>
        <source>Gain K</source>
        <translation>增益 K</translation>
    </message>
    <message>
        <source>Integral time T_i</source>
        <translation>积分时间 T_i</translation>
    </message>
    <message>
        <source>Derivative time T_d</source>
        <translation>微分时间 T_d</translation>
    </message>
    <message>
        <source>Empty: no integral action</source>
        <translation>留空：无积分作用</translation>
    </message>
    <message>
        <source>Parallel form</source>
        <translation>并联形式</translation>
    </message>
    <message>
        <source>Standard form</source>
        <translation>标准形式</translation>
    </message>
    <message>
        <source>Series form</source>
        <translation>串联形式</translation>
    </message>
    <message>
        <source>Form of the gains</source>
        <translation>增益的形式</translation>
    </message>
    <message>
        <source>Full friction feed-forward from</source>
        <translation>摩擦前馈全量起始速度</translation>
    </message>
    <message>
        <source>Friction assist from an error of</source>
        <translation>摩擦补偿起始误差</translation>
    </message>
    <message>
        <source>Friction assist below a speed of</source>
        <translation>摩擦补偿速度上限</translation>
    </message>
</context>
<context>
    <name>halbench::app::HelpWindow</name>
    <message>
        <source>Close the help (Ctrl+W; Esc only when disarmed and idle)</source>
        <translation>关闭帮助（Ctrl+W；仅在未使能且空闲时可用 Esc）</translation>
    </message>
    <message>
        <source>This page is available in English only.</source>
        <translation>本页仅有英文版。</translation>
    </message>
    <message>
        <source>Previous page (Alt+Left)</source>
        <translation>上一页 (Alt+Left)</translation>
    </message>
    <message>
        <source>Help page &apos;%1&apos; not found.</source>
        <translation>未找到帮助页面“%1”。</translation>
    </message>
    <message>
        <source>Halbench help</source>
        <translation>Halbench 帮助</translation>
    </message>
    <message>
        <source>Help page</source>
        <translation>帮助页面</translation>
    </message>
    <message>
        <source>Alt+Left goes back</source>
        <translation>Alt+向左键返回</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentificationFigures</name>
    <message>
        <source>Joint 95 % confidence region of damping and friction</source>
        <translation>阻尼与摩擦的 95 % 联合置信域</translation>
    </message>
    <message>
        <source>fit forward</source>
        <translation>正向拟合</translation>
    </message>
    <message>
        <source>fit reverse</source>
        <translation>反向拟合</translation>
    </message>
    <message>
        <source>95 % joint region</source>
        <translation>95 % 联合置信域</translation>
    </message>
    <message>
        <source>Steady speed against current amplitude</source>
        <translation>稳态转速与电流幅值</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>电流幅值</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>viscous damping c</source>
        <translation>粘性阻尼 c</translation>
    </message>
    <message>
        <source>Coulomb friction K_f</source>
        <translation>库仑摩擦 K_f</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyForm</name>
    <message>
        <source>Increase this value or reduce the other</source>
        <translation>请增大此值或减小另一个</translation>
    </message>
    <message>
        <source>Smaller than &quot;%1&quot;.</source>
        <translation>小于“%1”。</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not valid. %3 Reset to %4 A.</source>
        <translation>%1：“%2”无效。%3 已恢复为 %4 A。</translation>
    </message>
    <message>
        <source>Show rarely used settings (Alt+A)</source>
        <translation>显示不常用的设置 (Alt+A)</translation>
    </message>
    <message>
        <source>Seed for plateau order and resampling; equal seeds give equal results</source>
        <translation>平台顺序和重采样的种子；相同种子给出相同结果</translation>
    </message>
    <message>
        <source>Known torque constant. Empty: unknown</source>
        <translation>已知转矩常数。留空：未知</translation>
    </message>
    <message>
        <source>Known Coulomb friction. Empty: unknown</source>
        <translation>已知库仑摩擦。留空：未知</translation>
    </message>
    <message>
        <source>Known viscous damping. Empty: unknown</source>
        <translation>已知粘性阻尼。留空：未知</translation>
    </message>
    <message>
        <source>Known inertia of all rotating parts, for absolute values. Empty: unknown</source>
        <translation>所有转动部分的已知惯量，用于得到绝对值。留空：未知</translation>
    </message>
    <message>
        <source>Both directions also show the asymmetry of friction</source>
        <translation>双向测量还可得到摩擦的不对称性</translation>
    </message>
    <message>
        <source>Increment of the current</source>
        <translation>电流增量</translation>
    </message>
    <message>
        <source>Last current of the sweep</source>
        <translation>测量序列的最后一个电流</translation>
    </message>
    <message>
        <source>First current of the sweep; well above the breakaway current</source>
        <translation>测量序列的第一个电流；应明显高于起动电流</translation>
    </message>
    <message>
        <source>F&amp;rom current</source>
        <translation>起始电流(&amp;R)</translation>
    </message>
    <message>
        <source>T&amp;o current</source>
        <translation>终止电流(&amp;O)</translation>
    </message>
    <message>
        <source>Ste&amp;p</source>
        <translation>步长(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Directions</source>
        <translation>方向(&amp;D)</translation>
    </message>
    <message>
        <source>Given inertia &amp;J</source>
        <translation>已知惯量 &amp;J</translation>
    </message>
    <message>
        <source>Given dampi&amp;ng c</source>
        <translation>已知阻尼 c(&amp;N)</translation>
    </message>
    <message>
        <source>Given torque constant φ</source>
        <translation>已知转矩常数 φ</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>随机种子(&amp;S)</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>未给定</translation>
    </message>
    <message>
        <source>both</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>&amp;Advanced</source>
        <translation>高级(&amp;A)</translation>
    </message>
    <message>
        <source>Advanced settings</source>
        <translation>高级设置</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>请更正或留空</translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation>请更正该数值</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Given friction K&lt;sub&gt;f&lt;/sub&gt;</source>
        <translation>已知摩擦 K&lt;sub&gt;f&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>Current to&amp;lerance</source>
        <translation>电流容差(&amp;L)</translation>
    </message>
    <message>
        <source>Limit of the drive&apos;s gain error, in per cent of the current. Empty: the published drive, 0.15 % at one sigma</source>
        <translation>驱动增益误差的界限，以电流的百分数计。留空：所发表的驱动，一个 sigma 为 0.15 %</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyPanel</name>
    <message>
        <source>Identify again if the motor has changed.</source>
        <translation>如果电机有变化，请重新辨识。</translation>
    </message>
    <message>
        <source>Identification cancelled. Nothing was changed.</source>
        <translation>辨识已取消。未更改任何内容。</translation>
    </message>
    <message>
        <source>Fitting the recorded motion</source>
        <translation>正在拟合记录的运动</translation>
    </message>
    <message>
        <source>Rotor turning: plateaus and coast-downs</source>
        <translation>转子转动中：平台与自由减速</translation>
    </message>
    <message>
        <source>Plateaus completed so far; the fit follows at the end</source>
        <translation>已完成的平台；最后进行拟合</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>返回设置；此结果保留到下一次运行</translation>
    </message>
    <message>
        <source>Save a file for the commands tune and analyse</source>
        <translation>保存供 tune 和 analyse 命令使用的文件</translation>
    </message>
    <message>
        <source>Design gains for this motor</source>
        <translation>为此电机设计增益</translation>
    </message>
    <message>
        <source>Tune with this model</source>
        <translation>用此模型整定</translation>
    </message>
    <message>
        <source>Show a saved model</source>
        <translation>显示已保存的模型</translation>
    </message>
    <message>
        <source>Measures damping, friction, torque constant and inertia with 95 % intervals, from steady currents and coast-downs.</source>
        <translation>由恒定电流和自由减速测量阻尼、摩擦、转矩常数和转动惯量，并给出 95 % 区间。</translation>
    </message>
    <message>
        <source>Assess</source>
        <translation>评估</translation>
    </message>
    <message>
        <source>Save as model</source>
        <translation>另存为模型</translation>
    </message>
    <message>
        <source>Model (*.json)</source>
        <translation>模型 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Excite</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Start identification</source>
        <translation>开始辨识</translation>
    </message>
    <message>
        <source>The rotor turns (Ctrl+Return); Esc stops it</source>
        <translation>转子会转动 (Ctrl+Return)；按 Esc 键停止</translation>
    </message>
    <message>
        <source>Load model…</source>
        <translation>载入模型…</translation>
    </message>
    <message>
        <source>Save as model…</source>
        <translation>另存为模型…</translation>
    </message>
    <message>
        <source>Identify again</source>
        <translation>重新辨识</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Identifying</source>
        <translation>正在辨识</translation>
    </message>
    <message>
        <source>Load model</source>
        <translation>载入模型</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyResultView</name>
    <message>
        <source>Joint 95 % confidence region of damping and friction</source>
        <translation>阻尼与摩擦的 95 % 联合置信域</translation>
    </message>
    <message>
        <source>Steady speed over current, and residuals</source>
        <translation>稳态转速与电流的关系，以及残差</translation>
    </message>
    <message>
        <source>Confidence region</source>
        <translation>置信域</translation>
    </message>
    <message>
        <source>Identified values</source>
        <translation>辨识值</translation>
    </message>
    <message>
        <source>Fit and residuals</source>
        <translation>拟合与残差</translation>
    </message>
    <message>
        <source>Pictures of the identification</source>
        <translation>辨识图</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyWords</name>
    <message>
        <source>Good; see the remarks below</source>
        <translation>良好；请留意下列说明</translation>
    </message>
    <message>
        <source>Another device is connected: %1.</source>
        <translation>当前连接的是另一台设备：%1。</translation>
    </message>
    <message>
        <source>Same as the connected device.</source>
        <translation>与当前连接的设备相同。</translation>
    </message>
    <message>
        <source>No device is connected for comparison.</source>
        <translation>没有连接可供比较的设备。</translation>
    </message>
    <message>
        <source>K_f/φ is the friction current during rotation. Calibrate gives another figure: the breakaway current from rest, usually more.</source>
        <translation>K_f/φ 是转动时的摩擦电流。标定得到的是另一个量：从静止起动的起动电流，通常更大。</translation>
    </message>
    <message>
        <source>Without inertia J or torque constant φ only ratios are identified; that is sufficient for tuning.</source>
        <translation>若无转动惯量 J 或转矩常数 φ，则只能辨识比值；这对整定已足够。</translation>
    </message>
    <message>
        <source>unknown device</source>
        <translation>未知设备</translation>
    </message>
    <message>
        <source>Unknown device</source>
        <translation>未知设备</translation>
    </message>
    <message>
        <source>Not required for tuning: the ratios are sufficient.</source>
        <translation>整定不需要：比值即可。</translation>
    </message>
    <message>
        <source>• run-ups and coast-downs besides the plateaus: then J or φ is sufficient</source>
        <translation>• 除平台外再加升速和自由减速：则 J 或 φ 即可</translation>
    </message>
    <message>
        <source>• torque constant φ (data sheet): gives c and K_f, not J</source>
        <translation>• 转矩常数 φ（数据手册）：可得 c 和 K_f，不能得到 J</translation>
    </message>
    <message>
        <source>• without data: fix a part of known inertia to the rotor and identify again</source>
        <translation>• 无数据时：在转子上固定一个惯量已知的部件，再次辨识</translation>
    </message>
    <message>
        <source>• torque constant φ (data sheet): gives J, c and K_f</source>
        <translation>• 转矩常数 φ（数据手册）：可得 J、c 和 K_f</translation>
    </message>
    <message>
        <source>• inertia J of all rotating parts (drawing or weighing): gives c, K_f and φ</source>
        <translation>• 所有转动部分的转动惯量 J（图纸或称重）：可得 c、K_f 和 φ</translation>
    </message>
    <message>
        <source>Not identifiable: %1. Angle and current give only ratios. To get the scale, provide one of:</source>
        <translation>不可辨识：%1。角度和电流只能给出比值。请提供以下一项以确定尺度：</translation>
    </message>
    <message>
        <source>Rejected: no reliable result</source>
        <translation>拒绝：没有可靠的结果</translation>
    </message>
    <message>
        <source>Doubtful: check the findings first</source>
        <translation>存疑：请先查看诊断</translation>
    </message>
    <message>
        <source>Good: the model fits the data</source>
        <translation>良好：模型与数据相符</translation>
    </message>
    <message>
        <source>Current up to %1 A. The run pauses for cooling if the coils come near %2 °C.</source>
        <translation>电流最大 %1 A。线圈接近 %2 °C 时暂停冷却。</translation>
    </message>
    <message>
        <source>Maximum current %1 A, maximum coil temperature %2 °C.</source>
        <translation>最大电流 %1 A，最高线圈温度 %2 °C。</translation>
    </message>
    <message>
        <source>both directions</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>Angle and current give only ratios; see below for the missing scale</source>
        <translation>角度和电流只能给出比值；所缺尺度见下文</translation>
    </message>
    <message>
        <source>identified</source>
        <translation>辨识得到</translation>
    </message>
    <message>
        <source>given</source>
        <translation>给定</translation>
    </message>
    <message>
        <source>not identifiable</source>
        <translation>不可辨识</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>in reverse</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>viscous damping c</source>
        <translation>粘性阻尼 c</translation>
    </message>
    <message>
        <source>Coulomb friction K_f</source>
        <translation>库仑摩擦 K_f</translation>
    </message>
    <message>
        <source>torque constant φ</source>
        <translation>转矩常数 φ</translation>
    </message>
    <message>
        <source>inertia J</source>
        <translation>转动惯量 J</translation>
    </message>
    <message>
        <source>asymmetry of the friction</source>
        <translation>摩擦的不对称性</translation>
    </message>
    <message>
        <source>Device %1, firmware %2</source>
        <translation>设备 %1，固件 %2</translation>
    </message>
    <message>
        <source>overrides %1</source>
        <translation>覆盖项 %1</translation>
    </message>
    <message>
        <source>Halbench %1</source>
        <translation>Halbench %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>种子 %1</translation>
    </message>
    <message>
        <source>started %1</source>
        <translation>开始于 %1</translation>
    </message>
    <message>
        <source>From the project: identified in virtual time, device %1.</source>
        <translation>来自项目：在虚拟时间内辨识，设备 %1。</translation>
    </message>
    <message>
        <source>From the project: identified %1, device %2.</source>
        <translation>来自项目：辨识时间 %1，设备 %2。</translation>
    </message>
    <message>
        <source>K_f/φ, friction as a current</source>
        <translation>K_f/φ，以电流表示的摩擦</translation>
    </message>
    <message>
        <source>What is the difference?</source>
        <translation>有何区别？</translation>
    </message>
    <message>
        <source>in virtual time, without a date</source>
        <translation>虚拟时间，无日期</translation>
    </message>
    <message>
        <source>%1 minutes of device time</source>
        <translation>设备时间 %1 分</translation>
    </message>
    <message>
        <source>coils up to %1 °C</source>
        <translation>线圈最高 %1 °C</translation>
    </message>
    <message>
        <source>The rotor will turn %1, about %2 turns in all, at up to %3, for %4 minutes of device time.</source>
        <translation>转子将%1转动，共约 %2 圈，最高 %3，历时 %4 分钟设备时间。</translation>
    </message>
    <message>
        <source>Device stops at %1. Gains and limits are always restored.</source>
        <translation>转速达到 %1 时设备停止。增益和限值总会恢复。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportForm</name>
    <message>
        <source>Enter the sampling rate in rows per second.</source>
        <translation>请输入采样率（每秒行数）。</translation>
    </message>
    <message>
        <source>none: use a fixed sampling rate</source>
        <translation>无：使用固定采样率</translation>
    </message>
    <message>
        <source>Sampling rate in rows per second</source>
        <translation>采样率（每秒行数）</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>采样率</translation>
    </message>
    <message>
        <source>Time column, or sampling rate in rows per second</source>
        <translation>时间列，或以每秒行数表示的采样率</translation>
    </message>
    <message>
        <source>Lines above the numbers</source>
        <translation>数字上方的行</translation>
    </message>
    <message>
        <source>Character before the decimals of a number</source>
        <translation>小数部分之前的字符</translation>
    </message>
    <message>
        <source>space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>制表符</translation>
    </message>
    <message>
        <source>Character between the columns</source>
        <translation>列之间的字符</translation>
    </message>
    <message>
        <source>detected: %1</source>
        <translation>识别结果：%1</translation>
    </message>
    <message>
        <source>not certain</source>
        <translation>不确定</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>分隔符</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>逗号</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>分号</translation>
    </message>
    <message>
        <source>none, one column</source>
        <translation>无，只有一列</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>小数点符号</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>表头</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>names, then units</source>
        <translation>名称，然后单位</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportTable</name>
    <message>
        <source>Unit of the numbers, e.g. rpm or mA; hyphen: no unit</source>
        <translation>数值的单位，例如 rpm 或 mA；连字符：无单位</translation>
    </message>
    <message>
        <source>Signal name of this column in the recording (F2 edits)</source>
        <translation>此列在记录中的信号名（按 F2 编辑）</translation>
    </message>
    <message>
        <source>Choose the time column above</source>
        <translation>请在上方选择时间列</translation>
    </message>
    <message>
        <source>First rows in the units of the recording, with the signal name of each column above</source>
        <translation>以记录的单位显示前几行，上方为各列的信号名</translation>
    </message>
    <message>
        <source>Preview of the first rows</source>
        <translation>前几行的预览</translation>
    </message>
    <message>
        <source>Set by you. Clear it (Delete) to use the value found in the table</source>
        <translation>由您设定。清空（Delete）则使用表中识别的值</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Name of column %1</source>
        <translation>列 %1 的名称</translation>
    </message>
    <message>
        <source>Unit of column %1</source>
        <translation>列 %1 的单位</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportView</name>
    <message>
        <source>A recording of this name exists already.</source>
        <translation>已有同名的记录。</translation>
    </message>
    <message>
        <source>Enter a name without a folder for the recording.</source>
        <translation>请输入不含文件夹的记录名称。</translation>
    </message>
    <message>
        <source>Answer above: %1.</source>
        <translation>请在上方回答：%1。</translation>
    </message>
    <message>
        <source>The file cannot be read with these settings; see the cause above.</source>
        <translation>无法用这些设置读取文件；原因见上方。</translation>
    </message>
    <message>
        <source>Reading the file.</source>
        <translation>正在读取文件。</translation>
    </message>
    <message>
        <source>Choose a file first. Uncertain settings are asked for here.</source>
        <translation>请先选择文件。不确定的设置会在此询问。</translation>
    </message>
    <message>
        <source>Choose file</source>
        <translation>选择文件</translation>
    </message>
    <message>
        <source>Missing for the import</source>
        <translation>导入所缺内容</translation>
    </message>
    <message>
        <source>Read all rows, save them as a recording and show it</source>
        <translation>读取所有行，保存为记录并显示</translation>
    </message>
    <message>
        <source>Name of the new recording in the recordings folder</source>
        <translation>新记录在记录文件夹中的名称</translation>
    </message>
    <message>
        <source>File to import</source>
        <translation>要导入的文件</translation>
    </message>
    <message>
        <source>Choose a data file of another program (Ctrl+I in the window)</source>
        <translation>选择其他程序的数据文件（窗口中按 Ctrl+I）</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Name of the recording</source>
        <translation>记录的名称</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Table (*.csv *.txt *.tsv *.dat);;All files (*)</source>
        <translation>表 (*.csv *.txt *.tsv *.dat);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>正在导入</translation>
    </message>
    <message>
        <source>Importing: %1 rows</source>
        <translation>正在导入：%1 行</translation>
    </message>
    <message>
        <source>Imported: %1 rows in %2</source>
        <translation>已导入：%1 行，保存在 %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportWords</name>
    <message>
        <source>Choose the time column or enter the sampling rate above. If the rows are out of order, sort the file.</source>
        <translation>请在上方选择时间列或输入采样率。若各行顺序错误，请先对文件排序。</translation>
    </message>
    <message>
        <source>Change the column&apos;s name or unit below, or choose another time column above.</source>
        <translation>请在下方更改该列的名称或单位，或在上方选择其他时间列。</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>文件的前几行</translation>
    </message>
    <message>
        <source>The file does not tell. Choose before importing</source>
        <translation>文件中无此信息。请在导入前选择</translation>
    </message>
    <message>
        <source>Uncertain: %1</source>
        <translation>不确定：%1</translation>
    </message>
    <message>
        <source>%1; read as %2</source>
        <translation>%1；读作 %2</translation>
    </message>
    <message>
        <source>unit of its numbers: %1</source>
        <translation>其数字的单位：%1</translation>
    </message>
    <message>
        <source>none: fixed sampling rate</source>
        <translation>无：固定采样率</translation>
    </message>
    <message>
        <source>time column</source>
        <translation>时间列</translation>
    </message>
    <message>
        <source>meaning of the first lines</source>
        <translation>前几行的含义</translation>
    </message>
    <message>
        <source>format of columns and numbers</source>
        <translation>列和数字的格式</translation>
    </message>
    <message>
        <source>Set separator, decimal sign, header and time above to match the file, or correct the file.</source>
        <translation>请在上方按文件设置分隔符、小数点符号、表头和时间，或修改文件。</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>单位未知</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>无单位</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>来自 %1</translation>
    </message>
    <message>
        <source>time [s]
by %1 rows a second</source>
        <translation>时间 [s]
每秒 %1 行</translation>
    </message>
    <message>
        <source>separator %1</source>
        <translation>分隔符 %1</translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation>小数逗号</translation>
    </message>
    <message>
        <source>decimal point</source>
        <translation>小数点</translation>
    </message>
    <message>
        <source>Please choose</source>
        <translation>请选择</translation>
    </message>
</context>
<context>
    <name>halbench::app::JogRow</name>
    <message>
        <source>Current while a button is held</source>
        <translation>按住按钮时的电流</translation>
    </message>
    <message>
        <source>Speed while a button is held</source>
        <translation>按住按钮时的速度</translation>
    </message>
    <message>
        <source>Moves forward while held (hold Space)</source>
        <translation>按住时向前运动（按住空格键）</translation>
    </message>
    <message>
        <source>Moves backward while held (hold Space)</source>
        <translation>按住时向后运动（按住空格键）</translation>
    </message>
    <message>
        <source>− Back</source>
        <translation>− 后退</translation>
    </message>
    <message>
        <source>Forward +</source>
        <translation>前进 +</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>点动转速</translation>
    </message>
    <message>
        <source>Jog current</source>
        <translation>点动电流</translation>
    </message>
</context>
<context>
    <name>halbench::app::LinkPanel</name>
    <message>
        <source>link: %1 packets/s, %2 lost, %3 damaged, %4 ms (max. %5 ms)</source>
        <translation>链路：%1 包/秒，丢失 %2，损坏 %3，%4 ms（最大 %5 ms）</translation>
    </message>
    <message>
        <source>Packets per second (device time), lost, damaged, response time median and maximum</source>
        <translation>每秒数据包数（设备时间）、丢失、损坏、响应时间中位数和最大值</translation>
    </message>
    <message>
        <source>Link statistics</source>
        <translation>链路统计</translation>
    </message>
    <message>
        <source>link: connecting</source>
        <translation>链路：正在连接</translation>
    </message>
    <message>
        <source>link: none</source>
        <translation>链路：无</translation>
    </message>
    <message>
        <source>link: lost, reconnecting</source>
        <translation>链路：已断开，正在重连</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Unfold or fold the log (F9)</source>
        <translation>展开或收起日志 (F9)</translation>
    </message>
    <message>
        <source>Last message of the log</source>
        <translation>日志的最后一条消息</translation>
    </message>
    <message>
        <source>Signals sent to the plots</source>
        <translation>发送到曲线图的信号</translation>
    </message>
    <message>
        <source>recording of %1 s</source>
        <translation>%1 s 的记录</translation>
    </message>
    <message>
        <source>no signals</source>
        <translation>无信号</translation>
    </message>
    <message>
        <source>time advances only during a procedure</source>
        <translation>仅在流程运行时时间前进</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s), %1 Hz, samples lost: %2</source>
        <translation>
            <numerusform>%n 个信号，%1 Hz，丢失样本：%2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::LiveHall</name>
    <message>
        <source>Field measured by the Hall sensors</source>
        <translation>霍尔传感器测得的磁场</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
</context>
<context>
    <name>halbench::app::LivePicture</name>
    <message>
        <source>Connect the simulated motor</source>
        <translation>连接仿真电机</translation>
    </message>
    <message>
        <source>Save data…</source>
        <translation>保存数据…</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>保存数据</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::LivePlateaus</name>
    <message>
        <source>line forward</source>
        <translation>正向直线</translation>
    </message>
    <message>
        <source>line reverse</source>
        <translation>反向直线</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>plateaus so far</source>
        <translation>已完成的平台</translation>
    </message>
    <message>
        <source>Steady speed against current amplitude</source>
        <translation>稳态转速与电流幅值</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>电流幅值</translation>
    </message>
</context>
<context>
    <name>halbench::app::LogPanel</name>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已解除</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>执行器</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>started</source>
        <translation>已开始</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>started: %1</source>
        <translation>已开始：%1</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>found changed: %1</source>
        <translation>发现已改变：%1</translation>
    </message>
    <message>
        <source>history</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>done, good</source>
        <translation>完成，良好</translation>
    </message>
    <message>
        <source>done, doubtful</source>
        <translation>完成，存疑</translation>
    </message>
    <message>
        <source>done, rejected</source>
        <translation>完成，拒绝</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>失败：%1</translation>
    </message>
    <message>
        <source>ended: %1</source>
        <translation>已结束：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopCapture</name>
    <message>
        <source>Device lost before its capture settings were restored. Unless it was restarted, the settings of the last capture are still active</source>
        <translation>恢复捕获设置前设备已断开。除非已重启，否则上次捕获的设置仍然有效</translation>
    </message>
    <message>
        <source>capture</source>
        <translation>捕获</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopFigures</name>
    <message>
        <source>measured, low coherence</source>
        <translation>实测，相干性低</translation>
    </message>
    <message>
        <source>modulus margin</source>
        <translation>模裕度</translation>
    </message>
    <message>
        <source>imaginary part of L</source>
        <translation>L 的虚部</translation>
    </message>
    <message>
        <source>unit circle</source>
        <translation>单位圆</translation>
    </message>
    <message>
        <source>Nyquist plot of the open loop</source>
        <translation>开环 Nyquist 图</translation>
    </message>
    <message>
        <source>real part of L</source>
        <translation>L 的实部</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>Nichols plot of the open loop</source>
        <translation>开环 Nichols 图</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>sensitivity S</source>
        <translation>灵敏度 S</translation>
    </message>
    <message>
        <source>closed loop T</source>
        <translation>闭环 T</translation>
    </message>
    <message>
        <source>Sensitivity and closed loop</source>
        <translation>灵敏度与闭环</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopSliders</name>
    <message>
        <source>Requested %1; set to the nearest possible value.</source>
        <translation>要求 %1；已取最接近的可行值。</translation>
    </message>
    <message>
        <source>Limited to %1 (gain margin %2).</source>
        <translation>限于 %1（幅值裕度 %2）。</translation>
    </message>
    <message>
        <source>Limited to %1 (K_P would become zero).</source>
        <translation>限于 %1（K_P 会变为零）。</translation>
    </message>
    <message>
        <source>Limited to %1 (K_D would become negative).</source>
        <translation>限于 %1（K_D 会变为负值）。</translation>
    </message>
    <message>
        <source>Limited to %1 (end of range).</source>
        <translation>限于 %1（范围末端）。</translation>
    </message>
    <message>
        <source>Phase margin at the present crossover. Arrow keys: 1°, Page Up/Down: 5°</source>
        <translation>当前穿越频率处的相位裕度。方向键：1°，翻页键：5°</translation>
    </message>
    <message>
        <source>Gain crossover: closed-loop bandwidth; the phase margin is kept if possible. Arrow keys: 2 %, Page Up/Down: 25 %</source>
        <translation>增益穿越频率：闭环带宽；相位裕度尽可能保持。方向键：2 %，翻页键：25 %</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>速度(&amp;P)</translation>
    </message>
    <message>
        <source>Speed: gain crossover</source>
        <translation>速度：增益穿越频率</translation>
    </message>
    <message>
        <source>&amp;Robustness</source>
        <translation>稳健性(&amp;R)</translation>
    </message>
    <message>
        <source>Robustness: phase margin</source>
        <translation>稳健性：相位裕度</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopView</name>
    <message>
        <source>Plot the phase between -180° and 180°</source>
        <translation>将相位绘制在 -180° 与 180° 之间</translation>
    </message>
    <message>
        <source>Bode: magnitude and phase over frequency. Nyquist: locus around -1. Nichols: magnitude over phase. Sensitivity: disturbance rejection and reference tracking. Root locus: closed-loop poles over the gain</source>
        <translation>Bode：幅值和相位对频率。Nyquist：-1 周围的轨迹。Nichols：幅值对相位。灵敏度：扰动抑制和参考跟踪。根轨迹：闭环极点随增益的变化</translation>
    </message>
    <message>
        <source>Closed loop unstable: no sensitivity.</source>
        <translation>闭环不稳定：无灵敏度。</translation>
    </message>
    <message>
        <source>Open-loop plot</source>
        <translation>开环图</translation>
    </message>
    <message>
        <source>Bode</source>
        <translation>Bode</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>Nichols</source>
        <translation>Nichols</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>灵敏度</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Root locus</source>
        <translation>根轨迹</translation>
    </message>
    <message>
        <source>gain crossover</source>
        <translation>增益穿越频率</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>all gains, along the branch</source>
        <translation>所有增益，沿分支</translation>
    </message>
    <message>
        <source>Wrap the phase</source>
        <translation>折叠相位</translation>
    </message>
</context>
<context>
    <name>halbench::app::MainWindow</name>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Stop the actuator</source>
        <translation>停止执行器</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>by STOP of a dialog</source>
        <translation>由对话框的 STOP 触发</translation>
    </message>
    <message>
        <source>&amp;About Halbench</source>
        <translation>关于 Halbench(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>键盘快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>Open the project to restore it.</source>
        <translation>打开项目即可恢复。</translation>
    </message>
    <message>
        <source>Default plots are shown where the project is not valid: %1</source>
        <translation>项目中无效之处显示默认曲线图：%1</translation>
    </message>
    <message>
        <source>The running recording keeps its settings.</source>
        <translation>当前记录保持原有设置。</translation>
    </message>
    <message>
        <source>The project&apos;s recording settings apply from the next recording on.</source>
        <translation>项目中的记录设置从下一条记录起生效。</translation>
    </message>
    <message>
        <source>Deletion starts only after you have checked the list in Preferences.</source>
        <translation>只有在首选项中查看列表之后才会开始删除。</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of %1 exceed the limits in the preferences and are kept for now.</source>
        <translation>
            <numerusform>%n 条记录（%1）超过首选项的限值，暂时保留。</numerusform>
        </translation>
    </message>
    <message>
        <source>Import da&amp;ta (CSV)…</source>
        <translation>导入数据 (CSV)(&amp;T)…</translation>
    </message>
    <message>
        <source>Use them</source>
        <translation>使用它们</translation>
    </message>
    <message>
        <source>requested %1</source>
        <translation>%1请求</translation>
    </message>
    <message>
        <source>by STOP of the help window</source>
        <translation>由帮助窗口的“停止”</translation>
    </message>
    <message>
        <source>by STOP of a panel window</source>
        <translation>由面板窗口的“停止”</translation>
    </message>
    <message>
        <source>STOP and Esc remain active until then.</source>
        <translation>在此之前“停止”和 Esc 仍然有效。</translation>
    </message>
    <message>
        <source>The program closes after the running task is stopped and the actuator disarmed.</source>
        <translation>运行中的任务停止且执行器解除使能后，程序关闭。</translation>
    </message>
    <message>
        <source>Save the project to another place, or close without saving.</source>
        <translation>请将项目保存到别处，或不保存直接关闭。</translation>
    </message>
    <message>
        <source>The window stays open because of unsaved work.</source>
        <translation>因有未保存的工作，窗口保持打开。</translation>
    </message>
    <message>
        <source>The project&apos;s autosave could not be read; it was moved to %1.</source>
        <translation>项目的自动保存文件无法读取；已移到 %1。</translation>
    </message>
    <message>
        <source>Close it there, or open a copy as a new project.</source>
        <translation>请在那里关闭它，或将副本作为新项目打开。</translation>
    </message>
    <message>
        <source>They stay in the file unchanged; the rest is open.</source>
        <translation>这些内容在文件中保持原样；其余已打开。</translation>
    </message>
    <message>
        <source>Parts of the project could not be read: %1</source>
        <translation>项目中部分内容无法读取：%1</translation>
    </message>
    <message>
        <source>Save it with a name to keep it.</source>
        <translation>请命名保存以保留。</translation>
    </message>
    <message>
        <source>Restored your unsaved project.</source>
        <translation>已恢复未保存的项目。</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Connect the s&amp;imulated motor</source>
        <translation>连接仿真电机(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Help on this panel</source>
        <translation>此面板的帮助(&amp;H)</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>语言将在下次启动时更改。</translation>
    </message>
    <message>
        <source>unnamed project</source>
        <translation>未命名项目</translation>
    </message>
    <message>
        <source>%1[*] — Halbench</source>
        <translation>%1[*] — Halbench</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>首选项(&amp;P)…</translation>
    </message>
    <message>
        <source>%1 is open in another window.</source>
        <translation>%1 已在另一个窗口中打开。</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>打开副本</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>项目另存为…</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>仍然关闭</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>入门(&amp;F)</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>by Esc</source>
        <translation>由 Esc</translation>
    </message>
    <message>
        <source>by STOP</source>
        <translation>由“停止”</translation>
    </message>
    <message>
        <source>project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>首选项…</translation>
    </message>
    <message>
        <source>The file keeps these lines until the project is saved.</source>
        <translation>文件在项目保存之前保留这些行。</translation>
    </message>
    <message>
        <source>%1 has unsaved work of an earlier session.</source>
        <translation>%1 有上次会话未保存的工作。</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>&amp;Plots and STOP only</source>
        <translation>仅曲线图和停止(&amp;P)</translation>
    </message>
</context>
<context>
    <name>halbench::app::ModeBox</name>
    <message>
        <source>Idle: no current. Current: manual torque. Position: holds and follows.
D-axis: current that holds the rotor without torque (%1)</source>
        <translation>空闲：无电流。电流：手动转矩。位置：保持并跟随。
D 轴：无转矩地保持转子的电流 (%1)</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>D-axis</source>
        <translation>D 轴</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorCapture</name>
    <message>
        <source>Stopped after an event (Shift+T re-arms); %1</source>
        <translation>在一个事件后停止（Shift+T 重新准备）；%1</translation>
    </message>
    <message>
        <source>Reading the capture from the device, %1 %</source>
        <translation>正在从设备读取捕获，%1 %</translation>
    </message>
    <message>
        <source>Reading, %1 %</source>
        <translation>读取中，%1 %</translation>
    </message>
    <message>
        <source>Captured; read from the device after the recording, so that no sample is lost</source>
        <translation>已捕获；记录结束后再读取，以免丢失样本</translation>
    </message>
    <message>
        <source>Captured</source>
        <translation>已捕获</translation>
    </message>
    <message>
        <source>Triggered; capturing the time after the event</source>
        <translation>已触发；正在捕获事件之后的部分</translation>
    </message>
    <message>
        <source>Waiting until %1; captures %2</source>
        <translation>等待：%1；捕获 %2</translation>
    </message>
    <message>
        <source>Capturing the time before the event: %1</source>
        <translation>正在捕获事件之前的部分：%1</translation>
    </message>
    <message>
        <source>Filling pre-trigger</source>
        <translation>正在填充预触发</translation>
    </message>
    <message>
        <source>Setting up the capture of %1</source>
        <translation>正在设置捕获：%1</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>正在启动</translation>
    </message>
    <message>
        <source>A procedure is using the device; the capture continues afterwards</source>
        <translation>流程正在使用设备；捕获随后继续</translation>
    </message>
    <message>
        <source>On hold</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, %3 s, starting %4 s before the event</source>
        <translation>%1，%2 Hz，共 %3 s，从事件前 %4 s 开始</translation>
    </message>
    <message>
        <source>This device has no capture function.</source>
        <translation>此设备没有捕获功能。</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>已触发</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorData</name>
    <message>
        <source>; not included (other time axis): %1</source>
        <translation>；未包含（其他时间轴）：%1</translation>
    </message>
    <message>
        <source>Save the samples in view or between the cursors (CSV, MDF4, MAT)</source>
        <translation>保存视图内或光标之间的样本（CSV、MDF4、MAT）</translation>
    </message>
    <message>
        <source>Copy the samples in view or between the cursors as a table</source>
        <translation>将视图内或光标之间的样本复制为表格</translation>
    </message>
    <message>
        <source>Copy data</source>
        <translation>复制数据</translation>
    </message>
    <message>
        <source>Save data…</source>
        <translation>保存数据…</translation>
    </message>
    <message>
        <source>Copied: %1 rows</source>
        <translation>已复制：%1 行</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>保存数据</translation>
    </message>
    <message>
        <source>plots.csv</source>
        <translation>plots.csv</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4 *.mat)</source>
        <translation>记录 (*.csv *.mf4 *.mat)</translation>
    </message>
    <message>
        <source>Saved: %1 rows in %2</source>
        <translation>已保存：%1 行，%2</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorForecast</name>
    <message>
        <source>Time until the coil limit is reached</source>
        <translation>达到线圈限值的时间</translation>
    </message>
    <message>
        <source>Time to %1: %2.</source>
        <translation>到 %1 的时间：%2。</translation>
    </message>
    <message>
        <source>%1 stays below %2 for %3 at this load; final value not known yet.</source>
        <translation>在此负载下%1在 %3 内保持低于 %2；终值尚未知。</translation>
    </message>
    <message>
        <source>%1 stays below %2 at this load.</source>
        <translation>在此负载下%1保持低于 %2。</translation>
    </message>
    <message>
        <source>%1 stays below %2 at this load: final value %3 to %4 °C.</source>
        <translation>在此负载下%1保持低于 %2：终值 %3 到 %4 °C。</translation>
    </message>
    <message>
        <source>%1 reaches %2 at this load in %3 (95 %: %4 to %5).</source>
        <translation>在此负载下%1在 %3 后达到 %2（95 %：%4 到 %5）。</translation>
    </message>
    <message>
        <source>temperature does not follow a steady load</source>
        <translation>温度变化与恒定负载不符</translation>
    </message>
    <message>
        <source>temperature change below the sensor&apos;s resolution</source>
        <translation>温度变化低于传感器分辨率</translation>
    </message>
    <message>
        <source>needs %2 s of steady load (%1 s so far)</source>
        <translation>需要 %2 s 的稳定负载（目前 %1 s）</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 is at its limit of %2.</source>
        <translation>%1已达到限值 %2。</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPanel</name>
    <message>
        <source>The data shown may differ from the data recorded.</source>
        <translation>显示的数据可能与记录时不同。</translation>
    </message>
    <message>
        <source>The units of the preferences are used. Choose others in the legend (U). The project keeps its entries until you change the plots.</source>
        <translation>使用首选项中的单位。可在图例中另选（U）。更改曲线图之前，项目会保留其条目。</translation>
    </message>
    <message>
        <source>Units of the project that do not fit the signals: %1</source>
        <translation>项目中与信号不符的单位：%1</translation>
    </message>
    <message>
        <source>Plot the selected signal (Insert)</source>
        <translation>绘出所选信号（Insert）</translation>
    </message>
    <message>
        <source>Markers not saved: %1</source>
        <translation>标记未保存：%1</translation>
    </message>
    <message>
        <source>They are added after the recording, so that the recording has no gap.</source>
        <translation>记录结束后再加入，使记录没有间断。</translation>
    </message>
    <message>
        <source>These signals are sampled at other events than the others. Plot only signals of the same event together.</source>
        <translation>这些信号的采样事件与其他信号不同。请只将同一事件的信号绘制在一起。</translation>
    </message>
    <message>
        <source>Connect a device to see live data: choose one on the left, or try the simulated motor.</source>
        <translation>连接设备以查看实时数据：在左侧选择设备，或试用仿真电机。</translation>
    </message>
    <message>
        <source>No live data</source>
        <translation>无实时数据</translation>
    </message>
    <message>
        <source>They are not plotted. The project keeps them until you change the plots.</source>
        <translation>这些信号不绘制。更改曲线图之前，项目会保留它们。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>更多工具</translation>
    </message>
    <message>
        <source>Signals of the project that this device does not have: %1</source>
        <translation>项目中该设备没有的信号：%1</translation>
    </message>
    <message>
        <source>Connect the simulated motor</source>
        <translation>连接仿真电机</translation>
    </message>
    <message>
        <source>Not shown: %1</source>
        <translation>未显示：%1</translation>
    </message>
    <message>
        <source>Not in the running recording: %1</source>
        <translation>不在正在进行的记录中：%1</translation>
    </message>
    <message>
        <source>Plot fewer signals.</source>
        <translation>请减少所绘的信号。</translation>
    </message>
    <message>
        <source>Signal to plot</source>
        <translation>要绘出的信号</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPicture</name>
    <message>
        <source>Off: light background for paper and documents</source>
        <translation>关：浅色背景，适合纸张和文档</translation>
    </message>
    <message>
        <source>Pictures in window colours</source>
        <translation>图片采用窗口颜色</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Copy the plots as a picture</source>
        <translation>将曲线图复制为图片</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Save the plots as SVG, PDF or PNG</source>
        <translation>将曲线图保存为 SVG、PDF 或 PNG</translation>
    </message>
    <message>
        <source>Plots of %1</source>
        <translation>%1 的曲线图</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>plots.svg</source>
        <translation>plots.svg</translation>
    </message>
    <message>
        <source>Picture (*.svg *.pdf *.png)</source>
        <translation>图片 (*.svg *.pdf *.png)</translation>
    </message>
    <message>
        <source>%1, reference</source>
        <translation>%1，参考</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRate</name>
    <message>
        <source>Maximum of device and link</source>
        <translation>设备和链路的最大值</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Default (%1)</source>
        <translation>默认 (%1)</translation>
    </message>
    <message>
        <source>%1 is not possible for the plotted signals; %2 is used, the maximum of device and link.</source>
        <translation>所绘信号无法达到 %1；使用 %2，即设备和链路的最大值。</translation>
    </message>
    <message>
        <source>Sample rate of the plots, limited by device and link</source>
        <translation>曲线图的采样率，受设备和链路限制</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Live rate</source>
        <translation>实时速率</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRecording</name>
    <message>
        <source>Markers not saved: %1</source>
        <translation>标记未保存：%1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Showing %1</source>
        <translation>正在显示 %1</translation>
    </message>
    <message>
        <source>Cancelled: the plots show the first %1 s of %2 s.</source>
        <translation>已取消：曲线图显示 %2 s 中的前 %1 s。</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorReference</name>
    <message>
        <source>Reference curves: keep the view (K), a recording (Ctrl+K), none (Shift+K)</source>
        <translation>参考曲线：保留当前视图（K）、一条记录（Ctrl+K）、无（Shift+K）</translation>
    </message>
    <message>
        <source>Recording as reference</source>
        <translation>用记录作参考</translation>
    </message>
    <message>
        <source>Show a recording below the curves, aligned at trigger or start</source>
        <translation>在曲线下方显示一条记录，按触发或起点对齐</translation>
    </message>
    <message>
        <source>Recording as reference…</source>
        <translation>用记录作参考…</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>记录 (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorStatistics</name>
    <message>
        <source>Visible range of each plot</source>
        <translation>各曲线图的可见范围</translation>
    </message>
    <message>
        <source>Minimum, maximum, mean, rms and standard deviation in view or between cursors (S)</source>
        <translation>视图内或光标之间的最小值、最大值、均值、有效值和标准差 (S)</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>In view, %1 s</source>
        <translation>视图内，%1 s</translation>
    </message>
    <message>
        <source>Reading the disk</source>
        <translation>正在读取磁盘</translation>
    </message>
    <message>
        <source>A to B, %1 s</source>
        <translation>A 到 B，%1 s</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorTrigger</name>
    <message>
        <source>Stopped after the event at %1 s (Shift+T re-arms)</source>
        <translation>在 %1 s 的事件后停止（Shift+T 重新准备）</translation>
    </message>
    <message>
        <source>Auto: no event, free-running; waiting until %1</source>
        <translation>自动：没有事件，自由运行；等待：%1</translation>
    </message>
    <message>
        <source>Triggered; filling the window</source>
        <translation>已触发；正在填充窗口</translation>
    </message>
    <message>
        <source>No samples of %1</source>
        <translation>没有 %1 的采样</translation>
    </message>
    <message>
        <source>Clear the event and wait for the next one</source>
        <translation>清除事件并等待下一个</translation>
    </message>
    <message>
        <source>Re-arm trigger</source>
        <translation>重新准备触发</translation>
    </message>
    <message>
        <source>Oscilloscope view: time around the latest event</source>
        <translation>示波器视图：最新事件前后的时间</translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>Waiting until %1</source>
        <translation>等待：%1</translation>
    </message>
    <message>
        <source>Triggered at %1 s; waiting for the next</source>
        <translation>在 %1 s 触发；等待下一次</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>没有样本</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>已触发</translation>
    </message>
    <message>
        <source>Auto: no event</source>
        <translation>自动：没有事件</translation>
    </message>
    <message>
        <source>Triggered at %1 s</source>
        <translation>在 %1 s 触发</translation>
    </message>
    <message>
        <source>Stopped at %1 s</source>
        <translation>在 %1 s 停止</translation>
    </message>
</context>
<context>
    <name>halbench::app::NoteLabel</name>
    <message>
        <source>Opens the help (Tab, Return)</source>
        <translation>打开帮助（Tab，回车）</translation>
    </message>
</context>
<context>
    <name>halbench::app::NotesPanel</name>
    <message>
        <source>Notes on this motor; saved with the project</source>
        <translation>此电机的备注；随项目保存</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Notes on this motor; saved with the project.</source>
        <translation>对此电机的备注；随项目保存。</translation>
    </message>
</context>
<context>
    <name>halbench::app::NumberCheck</name>
    <message>
        <source>Reset to %1.</source>
        <translation>已恢复为 %1。</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not valid. No motion started.</source>
        <translation>%1：“%2”无效。未启动运动。</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceRow</name>
    <message>
        <source>Speed of the simulated motor or of the replay: 20 times runs two minutes in six seconds.
Keys in the Monitor: &lt; and &gt;. A real device always runs in real time.</source>
        <translation>仿真电机或回放的速度：20 倍时两分钟的过程用时六秒。
监视中的按键：&lt; 和 &gt;。真实设备始终实时运行。</translation>
    </message>
    <message>
        <source>Simulated &amp;time</source>
        <translation>仿真时间(&amp;T)</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>仿真时间</translation>
    </message>
    <message>
        <source>Speed of simulated time</source>
        <translation>仿真时间的速度</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceSteps</name>
    <message>
        <source>Speed up simulated or replayed time</source>
        <translation>加快仿真或回放时间</translation>
    </message>
    <message>
        <source>Slow down simulated or replayed time</source>
        <translation>减慢仿真或回放时间</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation>慢 %1 倍</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 倍</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>变慢</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>变快</translation>
    </message>
</context>
<context>
    <name>halbench::app::ParametersPanel</name>
    <message>
        <source>Save the values as a preset, or run the device with serve to keep them.</source>
        <translation>请将这些值保存为预设，或用 serve 运行设备以保留。</translation>
    </message>
    <message>
        <source>Save the edited column as a preset of this name (Enter in the name)</source>
        <translation>将编辑列保存为此名称的预设（在名称中按回车键）</translation>
    </message>
    <message>
        <source>Save the edited column as a preset of this name (Enter)</source>
        <translation>将编辑列保存为此名称的预设（回车键）</translation>
    </message>
    <message>
        <source>This device cannot write a complete set at once: values were changed one after the other.</source>
        <translation>此设备不能一次写入整组：各值是依次更改的。</translation>
    </message>
    <message>
        <source>The device does not allow writing to them or to its active page.</source>
        <translation>设备不允许写入这些参数或其活动页。</translation>
    </message>
    <message>
        <source>Read-only parameters: %1.</source>
        <translation>只读参数：%1。</translation>
    </message>
    <message>
        <source>The device lacks these parameters or does not allow these values.</source>
        <translation>设备没有这些参数，或不允许这些值。</translation>
    </message>
    <message>
        <source>Not loaded from the preset: %1</source>
        <translation>未从预设载入：%1</translation>
    </message>
    <message>
        <source>Active from the next power-up on.</source>
        <translation>下次上电起生效。</translation>
    </message>
    <message>
        <source>Saved to the device.</source>
        <translation>已保存到设备。</translation>
    </message>
    <message>
        <source>A simulated device cannot store values: it is reset at each connection.</source>
        <translation>仿真设备无法存储：每次连接都会复位。</translation>
    </message>
    <message>
        <source>Lost at power-off unless saved to the device.</source>
        <translation>未保存到设备则断电后丢失。</translation>
    </message>
    <message>
        <source>Save the active values to non-volatile memory for the next power-up</source>
        <translation>将当前值保存到非易失存储器，供下次上电使用</translation>
    </message>
    <message>
        <source>Save to device</source>
        <translation>保存到设备</translation>
    </message>
    <message>
        <source>preset name</source>
        <translation>预设名称</translation>
    </message>
    <message>
        <source>Load the preset into the rows; nothing is written yet</source>
        <translation>将预设载入各行；尚未写入</translation>
    </message>
    <message>
        <source>Named set of parameters, built-in or your own</source>
        <translation>一组命名的参数，内置或自定义</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>载入</translation>
    </message>
    <message>
        <source>Name of the new preset</source>
        <translation>新预设的名称</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation>
            <numerusform>已写入并回读 %n 个值。</numerusform>
        </translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>载入 %1</translation>
    </message>
    <message>
        <source>Save preset</source>
        <translation>保存预设</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Preset saved as %1.</source>
        <translation>预设已保存为 %1。</translation>
    </message>
</context>
<context>
    <name>halbench::app::PerspectiveBar</name>
    <message>
        <source>Layout for another task (Ctrl+1 to Ctrl+5)</source>
        <translation>切换任务布局 (Ctrl+1 至 Ctrl+5)</translation>
    </message>
    <message>
        <source>Layout for %1 (%2)</source>
        <translation>“%1”布局 (%2)</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>视角 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::PlotRows</name>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
</context>
<context>
    <name>halbench::app::PosePad</name>
    <message>
        <source>Jog pad</source>
        <translation>点动面板</translation>
    </message>
    <message>
        <source>Arrow keys jog the first two axes, Page Up and Page Down the third, while they are held</source>
        <translation>按住方向键点动前两个轴，Page Up 和 Page Down 点动第三个轴</translation>
    </message>
    <message>
        <source>Go to pose</source>
        <translation>前往位姿</translation>
    </message>
    <message>
        <source>Goes to this pose, one axis after the other, as even ramps</source>
        <translation>以匀速斜坡逐轴前往该位姿</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>Takes the pose where it is now</source>
        <translation>取当前位姿</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Counts the pitch cells from the present one; nothing moves</source>
        <translation>从当前节距单元开始计数；不产生运动</translation>
    </message>
    <message>
        <source>%1 while it is held (hold Space)</source>
        <translation>按住时%1（按住空格键）</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>位置 %1</translation>
    </message>
    <message>
        <source>Position to go to, absolute</source>
        <translation>目标位置（绝对）</translation>
    </message>
    <message>
        <source>Jog %1 backward</source>
        <translation>%1 反向点动</translation>
    </message>
    <message>
        <source>Jog %1 forward</source>
        <translation>%1 正向点动</translation>
    </message>
    <message>
        <source>The pose is beyond the excursion window of axis %1; nothing more was sent.</source>
        <translation>该位姿超出轴 %1 的偏移窗口；未再发送。</translation>
    </message>
    <message>
        <source>Widen the window on purpose, or disarm and arm to count anew.</source>
        <translation>请有意放宽窗口，或解除使能后重新使能以重新计数。</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreferencesDialog</name>
    <message>
        <source>Unit of the frequency axes; files use Hz</source>
        <translation>频率轴的单位；文件使用 Hz</translation>
    </message>
    <message>
        <source>Present history on disk</source>
        <translation>当前磁盘历史</translation>
    </message>
    <message>
        <source>Disk space for samples that do not fit into memory; the oldest are dropped first. 4 GB always stay free. Recordings are not affected</source>
        <translation>用于内存放不下的样本的磁盘空间；最旧的先丢弃。始终保留 4 GB 空闲。不影响记录</translation>
    </message>
    <message>
        <source>Maximum history on disk</source>
        <translation>磁盘历史上限</translation>
    </message>
    <message>
        <source>Discard the changes (Esc, which also stops)</source>
        <translation>放弃更改（Esc，同时会停止）</translation>
    </message>
    <message>
        <source>Apply the settings (Enter)</source>
        <translation>应用设置 (Enter)</translation>
    </message>
    <message>
        <source>Release dela&amp;y after stop</source>
        <translation>停止后的解除延时(&amp;Y)</translation>
    </message>
    <message>
        <source>Minimum time between a stop and its release</source>
        <translation>停止与解除之间的最短时间</translation>
    </message>
    <message>
        <source>Release delay after stop</source>
        <translation>停止后的解除延时</translation>
    </message>
    <message>
        <source>Unit of displayed speeds; files always use SI units</source>
        <translation>显示转速的单位；文件始终使用 SI 单位</translation>
    </message>
    <message>
        <source>Unit of displayed angles; files always use SI units</source>
        <translation>显示角度的单位；文件始终使用 SI 单位</translation>
    </message>
    <message>
        <source>Language of the window; files are not affected</source>
        <translation>窗口的语言；不影响文件</translation>
    </message>
    <message>
        <source>same as system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>窗口的颜色</translation>
    </message>
    <message>
        <source>light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Angles in</source>
        <translation>角度单位(&amp;A)</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>弧度</translation>
    </message>
    <message>
        <source>&amp;Speeds in</source>
        <translation>转速单位(&amp;S)</translation>
    </message>
    <message>
        <source>revolutions per minute</source>
        <translation>转每分</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>度每秒</translation>
    </message>
    <message>
        <source>radians per second</source>
        <translation>弧度每秒</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>used: %1 GB</source>
        <translation>已用：%1 GB</translation>
    </message>
    <message>
        <source>&amp;History on the disk</source>
        <translation>磁盘上的历史(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Frequencies in</source>
        <translation>频率单位(&amp;F)</translation>
    </message>
    <message>
        <source>hertz</source>
        <translation>赫兹</translation>
    </message>
</context>
<context>
    <name>halbench::app::Preflight</name>
    <message>
        <source>The axes may move now</source>
        <translation>现在各轴可以运动</translation>
    </message>
    <message>
        <source>A real actuator moves only after your confirmation</source>
        <translation>真实执行器只有在您确认后才会运动</translation>
    </message>
    <message>
        <source>A real motor moves only after your confirmation</source>
        <translation>真实电机只有在您确认后才会运动</translation>
    </message>
    <message>
        <source>The rotor may turn now</source>
        <translation>转子现在可以转动</translation>
    </message>
    <message>
        <source>Checks before the start</source>
        <translation>启动前检查</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreflightWords</name>
    <message>
        <source>Every axis is free to move and clear of people</source>
        <translation>各轴可自由运动且附近无人</translation>
    </message>
    <message>
        <source>Check, then start</source>
        <translation>请检查，然后启动</translation>
    </message>
    <message>
        <source>The stop was released just now</source>
        <translation>停止刚刚解除</translation>
    </message>
    <message>
        <source>Press Release next to the state at the top</source>
        <translation>请按上方状态旁边的“解除”</translation>
    </message>
    <message>
        <source>Use it by signal and parameter name in Signals, Record and Parameters</source>
        <translation>可在“信号”、“记录”和“参数”中按名称使用</translation>
    </message>
    <message>
        <source>No profile for the motor of this device</source>
        <translation>没有此设备电机的配置</translation>
    </message>
    <message>
        <source>Plug it in or switch it on</source>
        <translation>请插上或接通电源</translation>
    </message>
    <message>
        <source>Connection lost, reconnecting</source>
        <translation>连接已断开，正在重连</translation>
    </message>
    <message>
        <source>%1, up to %2 expected</source>
        <translation>%1，预计最高 %2</translation>
    </message>
    <message>
        <source>Check, then confirm below</source>
        <translation>请检查，然后在下面确认</translation>
    </message>
    <message>
        <source>Rotor is free to turn and clear of people</source>
        <translation>转子可自由转动，且无人靠近</translation>
    </message>
    <message>
        <source>Simulated: no collision possible</source>
        <translation>仿真：不可能碰撞</translation>
    </message>
    <message>
        <source>Use less current or fewer steps to stay below %1</source>
        <translation>请减小电流或步数，以保持低于 %1</translation>
    </message>
    <message>
        <source>%1; the run pauses near %2</source>
        <translation>%1；接近 %2 时运行暂停</translation>
    </message>
    <message>
        <source>Coil temperature unknown; it is measured first</source>
        <translation>线圈温度未知；将首先测量</translation>
    </message>
    <message>
        <source>The device is armed manually</source>
        <translation>设备已被手动使能</translation>
    </message>
    <message>
        <source>Remove the cause, then release the stop in the Drive panel</source>
        <translation>请排除原因，然后在“驱动”面板中解除停止</translation>
    </message>
    <message>
        <source>Device connected and idle</source>
        <translation>设备已连接且空闲</translation>
    </message>
    <message>
        <source>Wait until it ends, or cancel it</source>
        <translation>请等待其结束或取消它</translation>
    </message>
    <message>
        <source>Another procedure is running</source>
        <translation>另一个流程正在运行</translation>
    </message>
    <message>
        <source>No device is connected</source>
        <translation>没有连接设备</translation>
    </message>
    <message>
        <source>Connect one in the Devices panel</source>
        <translation>请在“设备”面板中连接</translation>
    </message>
    <message>
        <source>Fault: %1</source>
        <translation>故障：%1</translation>
    </message>
    <message>
        <source>The stop is latched</source>
        <translation>停止处于锁存状态</translation>
    </message>
    <message>
        <source>Disarm it first</source>
        <translation>请先解除使能</translation>
    </message>
    <message>
        <source>No fault, not stopped, not armed</source>
        <translation>无故障，未停止，未使能</translation>
    </message>
    <message>
        <source>Coils %1 now</source>
        <translation>线圈当前 %1</translation>
    </message>
    <message>
        <source>No fault, not stopped</source>
        <translation>无故障，未停止</translation>
    </message>
</context>
<context>
    <name>halbench::app::ProjectMenu</name>
    <message>
        <source>Disarm, or wait for the end of the procedure, then open the project.</source>
        <translation>请先解除使能，或等待流程结束，再打开项目。</translation>
    </message>
    <message>
        <source>A project cannot be opened while the actuator is armed or a procedure is running: a slow disk would delay Esc.</source>
        <translation>执行器已使能或流程运行时不能打开项目：慢速磁盘会延误 Esc。</translation>
    </message>
    <message>
        <source>Save it with a new name to keep it.</source>
        <translation>请用新名称保存以保留。</translation>
    </message>
    <message>
        <source>This is a copy of %1, without a name.</source>
        <translation>这是 %1 的副本，尚未命名。</translation>
    </message>
    <message>
        <source>The saved file is unchanged.</source>
        <translation>已保存的文件未改变。</translation>
    </message>
    <message>
        <source>The project&apos;s autosave could not be read; it was moved to %1.</source>
        <translation>项目的自动保存文件无法读取；已移到 %1。</translation>
    </message>
    <message>
        <source>%1 opened with unsaved changes.</source>
        <translation>%1 已打开，含未保存的更改。</translation>
    </message>
    <message>
        <source>No recent projects</source>
        <translation>没有最近的项目</translation>
    </message>
    <message>
        <source>Unsaved work of %1 was recovered. Save it to keep it.</source>
        <translation>已恢复 %1 中未保存的工作。请保存以保留。</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>新建项目(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>打开项目(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近的项目(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>保存项目(&amp;S)</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>项目另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>Halbench project (*.toml)</source>
        <translation>Halbench 项目 (*.toml)</translation>
    </message>
    <message>
        <source>Save project as</source>
        <translation>项目另存为</translation>
    </message>
    <message>
        <source>%1 is open in another window.</source>
        <translation>%1 已在另一个窗口中打开。</translation>
    </message>
    <message>
        <source>Choose another name, or close the other window.</source>
        <translation>请选择其他名称，或关闭另一个窗口。</translation>
    </message>
    <message>
        <source>Unnamed project, %1</source>
        <translation>未命名项目，%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::ProjectWork</name>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordButton</name>
    <message>
        <source>Waiting for the trigger; click to cancel (Ctrl+R)</source>
        <translation>等待触发；单击取消（Ctrl+R）</translation>
    </message>
    <message>
        <source>Waiting for the trigger</source>
        <translation>等待触发</translation>
    </message>
    <message>
        <source>Disk too slow: samples are lost.</source>
        <translation>磁盘太慢：样本丢失。</translation>
    </message>
    <message>
        <source>Record the measured signals to a file (Ctrl+R)</source>
        <translation>将测量信号记录到文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Recording to a file; click to stop (Ctrl+R)</source>
        <translation>正在记录到文件；单击停止 (Ctrl+R)</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Record data</source>
        <translation>记录数据</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>正在记录 %1</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待中</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordPanel</name>
    <message>
        <source>Live rate: as the plots; limited by device and link</source>
        <translation>实时速率：与曲线图相同；受设备和链路限制</translation>
    </message>
    <message>
        <source>live rate</source>
        <translation>实时速率</translation>
    </message>
    <message>
        <source>Without file extension; empty: name mask %1 (File &gt; Preferences)</source>
        <translation>不含扩展名；留空：名称模板 %1（文件 &gt; 首选项）</translation>
    </message>
    <message>
        <source>Value of {name} in the name mask %1 (File &gt; Preferences)</source>
        <translation>名称模板 %1 中 {name} 的值（文件 &gt; 首选项）</translation>
    </message>
    <message>
        <source>Record from the next trigger event on (Ctrl+R)</source>
        <translation>从下一个触发事件起记录（Ctrl+R）</translation>
    </message>
    <message>
        <source>Cancel without recording (Ctrl+R)</source>
        <translation>取消，不记录（Ctrl+R）</translation>
    </message>
    <message>
        <source>Cancel the wait</source>
        <translation>取消等待</translation>
    </message>
    <message>
        <source>No samples of the trigger signal.</source>
        <translation>没有触发信号的样本。</translation>
    </message>
    <message>
        <source>Trigger event of the recording</source>
        <translation>记录的触发事件</translation>
    </message>
    <message>
        <source>Post-trigger</source>
        <translation>后触发</translation>
    </message>
    <message>
        <source>Pre-trigger</source>
        <translation>预触发</translation>
    </message>
    <message>
        <source>The recording stops this long after the event; 0: manually</source>
        <translation>事件后经过此时间停止记录；0：手动</translation>
    </message>
    <message>
        <source>Post-trigger time</source>
        <translation>后触发时间</translation>
    </message>
    <message>
        <source>At the trigger: Ctrl+R waits for the Monitor&apos;s trigger event (T in the plots shows the trigger)</source>
        <translation>触发时：Ctrl+R 等待监视器的触发事件（在曲线图中按 T 显示触发）</translation>
    </message>
    <message>
        <source>manually</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Time before the start that is included in the recording; 0: none</source>
        <translation>包含在记录中的开始前时间；0：无</translation>
    </message>
    <message>
        <source>Pre-trigger time</source>
        <translation>预触发时间</translation>
    </message>
    <message>
        <source>Use another disk or a lower sample rate.</source>
        <translation>请使用另一块磁盘或降低采样率。</translation>
    </message>
    <message>
        <source>Disk too slow: samples are lost.</source>
        <translation>磁盘太慢：样本丢失。</translation>
    </message>
    <message>
        <source>%1 of them because of a slow disk.</source>
        <translation>其中 %1 个因磁盘太慢丢失。</translation>
    </message>
    <message>
        <source>Lost: %1; positions in the .meta.json file.</source>
        <translation>丢失：%1；位置见 .meta.json 文件。</translation>
    </message>
    <message>
        <source>Data file with units; settings and markers are in the .meta.json file beside it.</source>
        <translation>数据文件含单位；设置和标记在旁边的 .meta.json 文件中。</translation>
    </message>
    <message>
        <source>Record the measured signals to a file (Ctrl+R)</source>
        <translation>将测量信号记录到文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Stop and complete the file (Ctrl+R)</source>
        <translation>停止并完成文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>停止记录</translation>
    </message>
    <message>
        <source>Add a marker at this time (Enter in the note)</source>
        <translation>在此刻添加标记（在备注中按回车键）</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>添加标记</translation>
    </message>
    <message>
        <source>Text of the marker (Enter adds it)</source>
        <translation>标记文字（回车键添加）</translation>
    </message>
    <message>
        <source>Lost on the link or by a slow disk; marked in the file</source>
        <translation>链路丢失或磁盘太慢；已在文件中标明</translation>
    </message>
    <message>
        <source>Samples lost</source>
        <translation>丢失样本</translation>
    </message>
    <message>
        <source>Samples written</source>
        <translation>已写入样本</translation>
    </message>
    <message>
        <source>Device time from the first sample to the last</source>
        <translation>从第一个样本到最后一个样本的设备时间</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>采样率</translation>
    </message>
    <message>
        <source>Created if it does not exist</source>
        <translation>不存在时自动创建</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>记录文件夹</translation>
    </message>
    <message>
        <source>Name of the recording</source>
        <translation>记录名称</translation>
    </message>
    <message>
        <source>device and date</source>
        <translation>设备和日期</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>On the disk</source>
        <translation>已存盘</translation>
    </message>
    <message>
        <source>Note of the marker</source>
        <translation>标记备注</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>开始记录</translation>
    </message>
    <message>
        <source>%1 (gaps: %2, %3 s)</source>
        <translation>%1（间断：%2 处，%3 s）</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) in %1</source>
        <translation>
            <numerusform>%1 中有 %Ln 行</numerusform>
        </translation>
    </message>
    <message>
        <source>at the trigger</source>
        <translation>触发时</translation>
    </message>
    <message>
        <source>Start of the recording</source>
        <translation>记录的开始</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Waiting until %1.</source>
        <translation>等待：%1。</translation>
    </message>
    <message>
        <source>Begins when %1.</source>
        <translation>开始条件：%1。</translation>
    </message>
    <message>
        <source>In memory: %1 of %2 s.</source>
        <translation>内存中：%1 / %2 s。</translation>
    </message>
    <message>
        <source>Wait for the trigger</source>
        <translation>等待触发</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordedMarkers</name>
    <message>
        <source>marker</source>
        <translation>标记</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingControl</name>
    <message>
        <source>Maximum of device and link: %1 Hz. Choose a lower rate, or plot fewer signals.</source>
        <translation>设备和链路的最大值：%1 Hz。请降低速率，或减少所绘的信号。</translation>
    </message>
    <message>
        <source>The plotted signals cannot be recorded at %1 Hz.</source>
        <translation>所绘信号无法以 %1 Hz 记录。</translation>
    </message>
    <message>
        <source>%1. The data recorded until then are in %2.</source>
        <translation>%1。此前记录的数据在 %2 中。</translation>
    </message>
    <message>
        <source>Choose another name; existing recordings are not overwritten.</source>
        <translation>请换一个名称；不会覆盖已有记录。</translation>
    </message>
    <message>
        <source>Nothing to record.</source>
        <translation>没有可记录的内容。</translation>
    </message>
    <message>
        <source>Connect a device first.</source>
        <translation>请先连接设备。</translation>
    </message>
    <message>
        <source>%1 exists already.</source>
        <translation>%1 已存在。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingFields</name>
    <message>
        <source>Nothing is deleted from %1: %2 has a date in the future. Check the clock.</source>
        <translation>不会从 %1 删除任何内容：%2 的日期在未来。请检查时钟。</translation>
    </message>
    <message numerus="yes">
        <source>OK moves %n recording(s) to the trash now (%1), from %2.</source>
        <translation>
            <numerusform>按“确定”后 %n 条记录移到回收站（%1），来自 %2。</numerusform>
        </translation>
    </message>
    <message>
        <source>OK deletes nothing from %1 now.</source>
        <translation>按“确定”现在不会从 %1 删除任何记录。</translation>
    </message>
    <message>
        <source>Currently never.</source>
        <translation>当前从不删除。</translation>
    </message>
    <message>
        <source>Delete old recordings</source>
        <translation>删除旧记录</translation>
    </message>
    <message>
        <source>Recordings to be deleted now</source>
        <translation>现在将删除的记录</translation>
    </message>
    <message>
        <source>Disk space above which recordings are deleted</source>
        <translation>超过此空间时删除记录</translation>
    </message>
    <message>
        <source>Delete recordings by disk space</source>
        <translation>按占用空间删除记录</translation>
    </message>
    <message>
        <source>Age at which recordings are deleted, in days</source>
        <translation>删除记录的天数</translation>
    </message>
    <message>
        <source>Delete recordings by age</source>
        <translation>按时间删除记录</translation>
    </message>
    <message>
        <source>a&amp;bove</source>
        <translation>超过大小(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;older than</source>
        <translation>超过时间(&amp;O)</translation>
    </message>
    <message>
        <source>The oldest recordings named by the program move to the trash. Recordings that are open, younger than a day or have tags, notes or results are kept</source>
        <translation>程序自动命名的最旧记录移到回收站。打开的、不到一天的以及有标签、备注或结果的记录保留</translation>
    </message>
    <message>
        <source>Names of unnamed recordings: {device}, {date} and {time} (UTC), {number}; {name} is set in the Record panel</source>
        <translation>未命名记录的名称：{device}、{date} 和 {time}（UTC）、{number}；{name} 在“记录”面板中设定</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>还有 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Names of recordings</source>
        <translation>记录的名称</translation>
    </message>
    <message>
        <source>Example of a recording&apos;s name</source>
        <translation>记录名称的示例</translation>
    </message>
    <message>
        <source>&amp;Names of recordings</source>
        <translation>记录的名称(&amp;N)</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 天</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>e.g. %1.csv</source>
        <translation>例如 %1.csv</translation>
    </message>
    <message>
        <source>Checking recordings…</source>
        <translation>正在检查记录…</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingPlace</name>
    <message>
        <source>Folder %1 of the last recording not found. Recordings are saved to %2.</source>
        <translation>未找到上次记录的文件夹 %1。记录将保存到 %2。</translation>
    </message>
    <message>
        <source>recordings</source>
        <translation>记录</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingTidying</name>
    <message>
        <source>nothing deleted: %1 has a date in the future, check the clock</source>
        <translation>未删除任何内容：%1 的日期在未来，请检查时钟</translation>
    </message>
    <message>
        <source>above the disk limit in the preferences</source>
        <translation>超过首选项的空间限值</translation>
    </message>
    <message>
        <source>older than the limit in the preferences</source>
        <translation>超过首选项的时间限值</translation>
    </message>
    <message>
        <source>not deleted: %1</source>
        <translation>未删除：%1</translation>
    </message>
    <message>
        <source>recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>moved to the trash: %1 (%2)</source>
        <translation>已移到回收站：%1（%2）</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingTrigger</name>
    <message>
        <source>the set-point changes</source>
        <translation>设定值改变</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingsPanel</name>
    <message>
        <source>Show in Tune how this move would run with the proposed gains</source>
        <translation>在整定中显示采用建议增益时此运动的结果</translation>
    </message>
    <message>
        <source>What-if</source>
        <translation>假设分析</translation>
    </message>
    <message>
        <source>Import creates a recording; the table is not changed.</source>
        <translation>导入会生成记录；原表不变。</translation>
    </message>
    <message>
        <source>This table is from another program. Check below how it is read.</source>
        <translation>该表来自其他程序。请在下方检查读取方式。</translation>
    </message>
    <message>
        <source>Replay the recording as a live device (Ctrl+Return). Disconnects the device; not available while it is armed, recording or busy</source>
        <translation>像实时设备一样回放该记录（Ctrl+回车）。会断开设备；设备已使能、正在记录或忙时不可用</translation>
    </message>
    <message>
        <source>Show the whole recording in the panels (Enter). Disconnects the device; not available while it is armed, recording or busy</source>
        <translation>在各面板中显示整条记录（回车）。会断开设备；设备已使能、正在记录或忙时不可用</translation>
    </message>
    <message>
        <source>Enter opens the selected recording; several are overlaid</source>
        <translation>回车打开所选记录；选择多条则叠加</translation>
    </message>
    <message>
        <source>The damaged file was saved as %1.</source>
        <translation>损坏的文件已另存为 %1。</translation>
    </message>
    <message>
        <source>Lost: %1 bytes, damaged or at the end.</source>
        <translation>丢失：%1 字节，损坏或位于末尾。</translation>
    </message>
    <message>
        <source>All written data were recovered.</source>
        <translation>已写入的数据全部恢复。</translation>
    </message>
    <message>
        <source>No recordings in %1 yet. To make one: Record data (Ctrl+R).</source>
        <translation>%1 中还没有记录。新建：“记录数据”（Ctrl+R）。</translation>
    </message>
    <message>
        <source>Saved in the .meta.json file</source>
        <translation>保存在 .meta.json 文件中</translation>
    </message>
    <message>
        <source>Search words, saved in the .meta.json file</source>
        <translation>检索词，保存在 .meta.json 文件中</translation>
    </message>
    <message>
        <source>Recover an interrupted recording</source>
        <translation>恢复中断的记录</translation>
    </message>
    <message>
        <source>Start time of the replay; Enter jumps there</source>
        <translation>回放的起始时间；按回车跳转</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>起始于</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Read the folder again (F5)</source>
        <translation>重新读取文件夹（F5）</translation>
    </message>
    <message>
        <source>All words must occur (Ctrl+F)</source>
        <translation>必须包含所有词（Ctrl+F）</translation>
    </message>
    <message>
        <source>Search recordings</source>
        <translation>搜索记录</translation>
    </message>
    <message>
        <source>Search name, device, date, signals, tags, notes</source>
        <translation>搜索名称、设备、日期、信号、标签、备注</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>刷新</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>记录列表</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>Results over time</source>
        <translation>结果随时间变化</translation>
    </message>
    <message>
        <source>Tags and notes</source>
        <translation>标签和备注</translation>
    </message>
    <message>
        <source>Tags of the recording</source>
        <translation>记录的标签</translation>
    </message>
    <message>
        <source>Tags, with commas between them</source>
        <translation>标签，用逗号分隔</translation>
    </message>
    <message>
        <source>Notes on the recording</source>
        <translation>记录的备注</translation>
    </message>
    <message>
        <source>Notes on this recording</source>
        <translation>此记录的备注</translation>
    </message>
    <message>
        <source>An interrupted recording was recovered: %1 s in %2</source>
        <translation>已恢复一条中断的记录：%1 s，位于 %2</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Overlay, results, tags and notes, import</source>
        <translation>叠加、结果、标签和备注、导入</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Select a recording to open or replay it.</source>
        <translation>选择一个记录以打开或回放。</translation>
    </message>
    <message>
        <source>Several are overlaid below; select one to open it.</source>
        <translation>多个记录在下方叠加显示；只选一个即可打开。</translation>
    </message>
    <message>
        <source>Interrupted: recover it first.</source>
        <translation>记录中断：请先恢复。</translation>
    </message>
    <message>
        <source>End the current recording first.</source>
        <translation>请先结束当前记录。</translation>
    </message>
    <message>
        <source>Disarm the device first.</source>
        <translation>请先解除使能。</translation>
    </message>
    <message>
        <source>Wait for the end of the procedure.</source>
        <translation>请等待流程结束。</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>复制路径</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>The recording cannot be opened now.</source>
        <translation>现在无法打开该记录。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingsTableModel</name>
    <message>
        <source>interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>%1 (%2 rows)</source>
        <translation>%1（%2 行）</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1（仿真）</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>间断</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReferenceForm</name>
    <message>
        <source>Allowed: 1 to 32.</source>
        <translation>允许 1 到 32 个。</translation>
    </message>
    <message>
        <source>%1 plateaus entered.</source>
        <translation>已输入 %1 个平台。</translation>
    </message>
    <message>
        <source>Enter currents in A, e.g. 1.6; 2; 2.4.</source>
        <translation>请以 A 为单位输入电流，例如 1.6; 2; 2.4。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid current.</source>
        <translation>“%1”不是有效的电流值。</translation>
    </message>
    <message>
        <source>Up to 32 currents in A, separated by spaces or semicolons</source>
        <translation>最多 32 个电流值（A），用空格或分号隔开</translation>
    </message>
    <message>
        <source>Generator signal added to the set-point</source>
        <translation>叠加到设定值上的发生器信号</translation>
    </message>
    <message>
        <source>Time of each current</source>
        <translation>每个电流的持续时间</translation>
    </message>
    <message>
        <source>Plateau time</source>
        <translation>平台时间</translation>
    </message>
    <message>
        <source>Afterwards a position is held and a current goes to zero</source>
        <translation>之后位置保持，电流归零</translation>
    </message>
    <message>
        <source>Constant speed or current added to the shape</source>
        <translation>叠加到波形上的恒定速度或恒定电流</translation>
    </message>
    <message>
        <source>Phase seed of the multisine; 0: low crest factor</source>
        <translation>多正弦相位的种子；0：低峰值因数</translation>
    </message>
    <message>
        <source>Steps of a staircase, lines of a multisine (max. 32)</source>
        <translation>阶梯的级数、多正弦的谱线数（最多 32）</translation>
    </message>
    <message>
        <source>Number of steps</source>
        <translation>级数</translation>
    </message>
    <message>
        <source>Time of each step</source>
        <translation>每级的持续时间</translation>
    </message>
    <message>
        <source>Step time</source>
        <translation>每级时间</translation>
    </message>
    <message>
        <source>End frequency of chirp and multisine</source>
        <translation>扫频和多正弦的终止频率</translation>
    </message>
    <message>
        <source>End frequency</source>
        <translation>终止频率</translation>
    </message>
    <message>
        <source>Frequency of the sine; start frequency of chirp and multisine</source>
        <translation>正弦的频率；扫频和多正弦的起始频率</translation>
    </message>
    <message>
        <source>Slope of the ramp; negative: backward</source>
        <translation>斜坡的斜率；负值：反向</translation>
    </message>
    <message>
        <source>Height of one step (step, staircase), amplitude (sine, chirp), rms (multisine), end value (ramp; 0: no end)</source>
        <translation>单步高度（阶跃、阶梯）、幅值（正弦、扫频）、有效值（多正弦）、终值（斜坡；0：无终点）</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>斜率</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>Chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>Multisine</source>
        <translation>多正弦</translation>
    </message>
    <message>
        <source>Speed plateaus</source>
        <translation>转速平台</translation>
    </message>
    <message>
        <source>Shape of the reference</source>
        <translation>参考信号波形</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>波形</translation>
    </message>
    <message>
        <source>Currents of the plateaus in ampere</source>
        <translation>各平台的电流（安培）</translation>
    </message>
    <message>
        <source>Currents (A)</source>
        <translation>电流 (A)</translation>
    </message>
    <message>
        <source>Offset speed (added)</source>
        <translation>附加偏置速度</translation>
    </message>
    <message>
        <source>Offset current (added)</source>
        <translation>附加偏置电流</translation>
    </message>
</context>
<context>
    <name>halbench::app::RelayForm</name>
    <message>
        <source>safe value</source>
        <translation>安全值</translation>
    </message>
    <message>
        <source>Cycles to measure, 40 to 400; the intervals shrink with the square root. Empty: 100</source>
        <translation>测量的振荡次数，40 至 400；区间随其平方根缩小。留空：100</translation>
    </message>
    <message>
        <source>Saturation current of the controller. Empty: maximum safe value</source>
        <translation>控制器的饱和电流。留空：最大安全值</translation>
    </message>
    <message>
        <source>Steady speed of the oscillation, at least 3 rad/s in either direction, so that friction acts as a constant offset. Empty: lowest safe value</source>
        <translation>振荡时的匀速转速，任一方向至少 3 rad/s，使摩擦成为恒定偏置。留空：最小安全值</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>振荡次数</translation>
    </message>
    <message>
        <source>Relay amplitude</source>
        <translation>继电幅值</translation>
    </message>
    <message>
        <source>&amp;Base speed</source>
        <translation>基础转速(&amp;B)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>请更正，或留空</translation>
    </message>
</context>
<context>
    <name>halbench::app::RelayPanel</name>
    <message>
        <source>Experiment cancelled. Nothing was changed.</source>
        <translation>实验已取消。未更改任何内容。</translation>
    </message>
    <message>
        <source>Oscillation as recorded</source>
        <translation>记录的振荡</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>返回设置；此结果保留到下一次运行</translation>
    </message>
    <message>
        <source>Save a file for tune --relay</source>
        <translation>保存供 tune --relay 使用的文件</translation>
    </message>
    <message>
        <source>Propose Ziegler-Nichols gains with their assessment; nothing is applied</source>
        <translation>按齐格勒—尼科尔斯方法提出增益并评估；不应用</translation>
    </message>
    <message>
        <source>The rotor turns and oscillates (Ctrl+Return); Esc stops it</source>
        <translation>转子转动并振荡（Ctrl+Return）；按 Esc 停止</translation>
    </message>
    <message>
        <source>The rotor turns steadily and oscillates. STOP (Esc) and Cancel end the run. Gains, limits, mode, windows and generator are restored.</source>
        <translation>转子匀速转动并振荡。“停止”（Esc）和“取消”结束实验。增益、限值、模式、窗口和发生器会恢复。</translation>
    </message>
    <message>
        <source>Measures the ultimate gain with its 95 % interval: the loop oscillates around a steady motion under saturating proportional control. Calibrate the sensors first.</source>
        <translation>测量临界增益及其 95 % 区间：回路在带饱和的比例控制下围绕匀速运动振荡。请先标定传感器。</translation>
    </message>
    <message>
        <source>Oscillate</source>
        <translation>振荡</translation>
    </message>
    <message>
        <source>Save result</source>
        <translation>保存结果</translation>
    </message>
    <message>
        <source>Relay experiment (*.json)</source>
        <translation>继电实验 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Start experiment</source>
        <translation>开始实验</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>用于整定</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>保存结果…</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Ultimate gain and period</source>
        <translation>临界增益和临界周期</translation>
    </message>
    <message>
        <source>Relay experiment</source>
        <translation>继电实验</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Computing the result</source>
        <translation>正在计算结果</translation>
    </message>
</context>
<context>
    <name>halbench::app::RelayWords</name>
    <message>
        <source>Speed range: %1 to %2 rad/s.</source>
        <translation>转速范围：%1 至 %2 rad/s。</translation>
    </message>
    <message>
        <source>%1 cycles of %2° with %3 A; frequency scatter %4 %.</source>
        <translation>%1 次振荡，幅值 %2°，电流 %3 A；频率离散 %4 %。</translation>
    </message>
    <message>
        <source>at %1 rad/s; extrapolated to −180°</source>
        <translation>在 %1 rad/s 处；外推到 −180°</translation>
    </message>
    <message>
        <source>phase at the oscillation</source>
        <translation>振荡处的相位</translation>
    </message>
    <message>
        <source>Device stops at %1 rad/s at the latest. Gains and limits are replaced during the experiment and always restored.</source>
        <translation>转速最迟达到 %1 rad/s 时设备停止。实验期间替换增益和限值，并总会恢复。</translation>
    </message>
    <message>
        <source>Maximum current %1 A, maximum coil temperature %2 °C.</source>
        <translation>最大电流 %1 A，最高线圈温度 %2 °C。</translation>
    </message>
    <message>
        <source>Oscillation of about %1° every %2 s, speed %3 to %4 rad/s. The speed keeps its sign; the run stops outside the expected range.</source>
        <translation>每 %2 s 振荡约 %1°，转速 %3 至 %4 rad/s。转速不变号；超出预期范围时运行停止。</translation>
    </message>
    <message>
        <source>No identified motor to compare with. Identify the motor.</source>
        <translation>没有可供比较的已辨识电机。请辨识电机。</translation>
    </message>
    <message>
        <source>The identified motor disagrees: the intervals do not overlap.</source>
        <translation>与已辨识的电机不一致：区间不重叠。</translation>
    </message>
    <message>
        <source>The identified motor agrees: the intervals overlap.</source>
        <translation>与已辨识的电机一致：区间重叠。</translation>
    </message>
    <message>
        <source>See the findings above for cause and remedy</source>
        <translation>原因和措施见上方的诊断</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>ultimate gain of the model</source>
        <translation>模型的临界增益</translation>
    </message>
    <message>
        <source>identified motor</source>
        <translation>已辨识的电机</translation>
    </message>
    <message>
        <source>published motor</source>
        <translation>公开的电机</translation>
    </message>
    <message>
        <source>ultimate gain</source>
        <translation>临界增益</translation>
    </message>
    <message>
        <source>ultimate period</source>
        <translation>临界周期</translation>
    </message>
</context>
<context>
    <name>halbench::app::StandstillRippleWords</name>
    <message>
        <source>current ripple at standstill about %1 A, more than angle noise (%2) explains: possible hunting; reduce K_D or K_P</source>
        <translation>静止时电流纹波约 %1 A，超过角度噪声（%2）的影响：可能存在游荡；请减小 K_D 或 K_P</translation>
    </message>
    <message>
        <source>current ripple at standstill about %1 A: noise of the measured angle (%2) multiplied by these gains</source>
        <translation>静止时电流纹波约 %1 A：测得角度的噪声（%2）乘以这些增益</translation>
    </message>
</context>
<context>
    <name>halbench::app::ResultHistoryView</name>
    <message>
        <source>Identification files (.json) of the folder, oldest first, with 95 % intervals; in brackets the drift since the first result of the same device</source>
        <translation>文件夹中的辨识文件（.json），最早的在前，附 95 % 区间；括号中为相对同一设备首个结果的漂移</translation>
    </message>
    <message>
        <source>Drift since the first result of this device: within the intervals</source>
        <translation>相对该设备首个结果的漂移：在区间之内</translation>
    </message>
    <message>
        <source>Drift since the first result of this device: outside both intervals</source>
        <translation>相对该设备首个结果的漂移：超出两个区间</translation>
    </message>
    <message>
        <source>Damping c</source>
        <translation>阻尼 c</translation>
    </message>
    <message>
        <source>Friction K_f</source>
        <translation>摩擦 K_f</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>转矩常数</translation>
    </message>
    <message>
        <source>Inertia J</source>
        <translation>转动惯量 J</translation>
    </message>
    <message>
        <source>%1 (given)</source>
        <translation>%1（给定）</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>simulated time</source>
        <translation>仿真时间</translation>
    </message>
    <message>
        <source>Identified values over time</source>
        <translation>辨识值随时间变化</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Data quality</source>
        <translation>数据质量</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReturnNotice</name>
    <message>
        <source>Old values written.</source>
        <translation>已写回旧值。</translation>
    </message>
    <message>
        <source>Values changed during the connection loss: %1.</source>
        <translation>断线期间改变的值：%1。</translation>
    </message>
    <message>
        <source>The changed values were edited in the meantime.</source>
        <translation>这些值在此期间已被编辑。</translation>
    </message>
    <message>
        <source>Its values are unchanged.</source>
        <translation>其数值未改变。</translation>
    </message>
    <message>
        <source>The recording continues with a gap.</source>
        <translation>记录将带间断继续。</translation>
    </message>
    <message>
        <source>The device&apos;s watchdog stops the motion.</source>
        <translation>设备的看门狗会停止运动。</translation>
    </message>
    <message>
        <source>Device values kept.</source>
        <translation>已保留设备的值。</translation>
    </message>
    <message>
        <source>The device may have restarted. Nothing was written.</source>
        <translation>设备可能已重启。未写入任何值。</translation>
    </message>
    <message>
        <source>Reconnected after %1 s, disarmed. Changed values: %2.</source>
        <translation>%1 s 后重新连接，未使能。已改变的值：%2。</translation>
    </message>
    <message>
        <source>Reconnected after %1 s, disarmed.</source>
        <translation>%1 s 后重新连接，未使能。</translation>
    </message>
    <message>
        <source>Reconnecting; last attempt: %1.</source>
        <translation>正在重新连接；上次尝试：%1。</translation>
    </message>
    <message>
        <source>Reconnecting.</source>
        <translation>正在重新连接。</translation>
    </message>
    <message>
        <source>Keep the values that are on the device now</source>
        <translation>保留设备上现有的值</translation>
    </message>
    <message>
        <source>Keep device values</source>
        <translation>保留设备的值</translation>
    </message>
    <message>
        <source>Write the values from before the loss and read them back</source>
        <translation>写回断开前的值并回读</translation>
    </message>
    <message>
        <source>Write old values</source>
        <translation>写回旧值</translation>
    </message>
    <message>
        <source>Left: before the connection was lost; right: now</source>
        <translation>左：断开前；右：现在</translation>
    </message>
    <message>
        <source>Changed values</source>
        <translation>已改变的值</translation>
    </message>
    <message>
        <source>Connection lost: %1.</source>
        <translation>连接已断开：%1。</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 个</translation>
    </message>
    <message>
        <source>Disconnect ends the search.</source>
        <translation>“断开”可结束搜索。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RootLocusFigure</name>
    <message>
        <source>damping ratio</source>
        <translation>阻尼比</translation>
    </message>
    <message>
        <source>gain from 0 to %1 times</source>
        <translation>增益从 0 到 %1 倍</translation>
    </message>
    <message>
        <source>imaginary part of z</source>
        <translation>z 的虚部</translation>
    </message>
    <message>
        <source>poles of the open loop</source>
        <translation>开环极点</translation>
    </message>
    <message>
        <source>zeros</source>
        <translation>零点</translation>
    </message>
    <message>
        <source>poles of the closed loop</source>
        <translation>闭环极点</translation>
    </message>
    <message>
        <source>real part of z</source>
        <translation>z 的实部</translation>
    </message>
    <message>
        <source>limit of stability</source>
        <translation>稳定界限</translation>
    </message>
    <message>
        <source>limit at gain factor</source>
        <translation>增益倍数界限</translation>
    </message>
    <message>
        <source>closed loop: %1</source>
        <translation>闭环：%1</translation>
    </message>
    <message>
        <source>Root locus</source>
        <translation>根轨迹</translation>
    </message>
</context>
<context>
    <name>halbench::app::RunOverlay</name>
    <message>
        <source>Compare it with a copy: samples may be missing or changed.</source>
        <translation>请与副本比较：样本可能缺失或已改变。</translation>
    </message>
    <message>
        <source>No common data in this range. Choose another signal, alignment or range.</source>
        <translation>此范围内没有共同数据。请选择其他信号、对齐点或范围。</translation>
    </message>
    <message>
        <source>Select recordings in the list to overlay their curves.</source>
        <translation>在列表中选择记录以叠加其曲线。</translation>
    </message>
    <message>
        <source>Maximum %1 recordings in an overlay</source>
        <translation>最多叠加 %1 条记录</translation>
    </message>
    <message>
        <source>%1 s around the cursor</source>
        <translation>光标周围 %1 s</translation>
    </message>
    <message>
        <source>Whole recording or a range around the cursor</source>
        <translation>整条记录，或光标周围的范围</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Alignment of the recordings</source>
        <translation>记录的对齐点</translation>
    </message>
    <message>
        <source>Position of the cursor line and of the values beside it</source>
        <translation>光标线及旁边数值的位置</translation>
    </message>
    <message>
        <source>Time zero: first sample, trigger, or a common marker</source>
        <translation>零时刻：首个样本、触发或共有标记</translation>
    </message>
    <message>
        <source>Signals common to all selected recordings</source>
        <translation>所选记录共有的信号</translation>
    </message>
    <message>
        <source>Values of each recording at the cursor</source>
        <translation>各记录在光标处的值</translation>
    </message>
    <message>
        <source>Overlay of the selected recordings</source>
        <translation>所选记录的叠加</translation>
    </message>
    <message>
        <source>Values at the cursor</source>
        <translation>光标处的值</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>At the cursor</source>
        <translation>光标处</translation>
    </message>
    <message>
        <source>Time of the cursor</source>
        <translation>光标时间</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Aligned at</source>
        <translation>对齐于</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Signal that is compared</source>
        <translation>比较的信号</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>marker: %1</source>
        <translation>标记：%1</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
</context>
<context>
    <name>halbench::app::ShownRecording</name>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
</context>
<context>
    <name>halbench::app::SignalTree</name>
    <message>
        <source>Tick to plot a signal (Enter or Space), or drag it onto a plot</source>
        <translation>勾选以绘制信号（回车或空格），或拖到曲线图上</translation>
    </message>
    <message>
        <source>Signals of the device</source>
        <translation>设备信号</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>最后</translation>
    </message>
    <message>
        <source>Plot, or remove from the plots</source>
        <translation>绘制，或从曲线图中移除</translation>
    </message>
    <message>
        <source>Copy the name for expressions and files</source>
        <translation>复制用于表达式和文件的名称</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramFigure</name>
    <message>
        <source>Bin width %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>谱线间隔 %1 Hz，分辨率 %2 Hz，分段 %3 s</translation>
    </message>
    <message>
        <source>Spectrogram of %1</source>
        <translation>%1 的频谱图</translation>
    </message>
    <message>
        <source>one every %1 s</source>
        <translation>每 %1 s 一个</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramRange</name>
    <message>
        <source>The minimum of the colour scale must be below its maximum. Automatic scale used.</source>
        <translation>色标最小值必须小于最大值。现使用自动色标。</translation>
    </message>
    <message>
        <source>The lowest frequency must be below the highest. All are shown.</source>
        <translation>最低频率必须低于最高频率。现显示全部。</translation>
    </message>
    <message>
        <source>Value of the brightest colour; empty: automatic</source>
        <translation>最亮颜色对应的值；空：自动</translation>
    </message>
    <message>
        <source>Colour scale max</source>
        <translation>色标最大值</translation>
    </message>
    <message>
        <source>Value of the darkest colour; empty: automatic</source>
        <translation>最暗颜色对应的值；空：自动</translation>
    </message>
    <message>
        <source>Colour scale min</source>
        <translation>色标最小值</translation>
    </message>
    <message>
        <source>Highest frequency shown; empty: all</source>
        <translation>显示的最高频率；空：全部</translation>
    </message>
    <message>
        <source>Max. [Hz]</source>
        <translation>最大 [Hz]</translation>
    </message>
    <message>
        <source>Lowest frequency shown; empty: all</source>
        <translation>显示的最低频率；空：全部</translation>
    </message>
    <message>
        <source>Min. [Hz]</source>
        <translation>最小 [Hz]</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumFigure</name>
    <message>
        <source>%1 (equal to %2 independent ones)</source>
        <translation>%1（相当于 %2 次独立平均）</translation>
    </message>
    <message>
        <source>no segment spans the %1 gaps and %2 missing values</source>
        <translation>分段不跨越 %1 处间断和 %2 个缺失值</translation>
    </message>
    <message>
        <source>Bin width %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>谱线间隔 %1 Hz，分辨率 %2 Hz，分段 %3 s</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>rms value</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>power density</source>
        <translation>功率谱密度</translation>
    </message>
    <message>
        <source>amplitude density</source>
        <translation>幅值谱密度</translation>
    </message>
    <message>
        <source>Spectrum of %1</source>
        <translation>%1 的频谱</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>95 % interval of noise: %1 to %2 times the line</source>
        <translation>噪声的 95 % 区间：谱线的 %1 至 %2 倍</translation>
    </message>
    <message>
        <source>rms of all lines %1 %2</source>
        <translation>全部谱线的有效值 %1 %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln average(s)</source>
        <translation>
            <numerusform>%Ln 次平均</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumPanel</name>
    <message>
        <source>Colour scale in dB relative to 1 of the unit</source>
        <translation>色标以 dB 表示，以单位的 1 为基准</translation>
    </message>
    <message>
        <source>Arrow keys move from the highest value (Shift: ten steps); Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>方向键从最大值开始移动（Shift：十步）；Ctrl+C 复制图片，Ctrl+E 保存</translation>
    </message>
    <message>
        <source>Spectrogram: spectra of the segments over time, in colours</source>
        <translation>频谱图：各分段频谱随时间的变化，以颜色表示</translation>
    </message>
    <message>
        <source>Spectrogram</source>
        <translation>频谱图</translation>
    </message>
    <message>
        <source>Local maxima outside the window&apos;s main lobe</source>
        <translation>窗主瓣之外的局部最大值</translation>
    </message>
    <message>
        <source>Overlap of neighbouring segments</source>
        <translation>相邻分段的重叠</translation>
    </message>
    <message>
        <source>Longer segments give finer resolution, more segments less noise. 0: full length for amplitudes, at least eight segments for densities</source>
        <translation>分段越长分辨率越高，分段越多噪声越小。0：幅值取全长，谱密度至少八段</translation>
    </message>
    <message>
        <source>Length of the analysed data, up to now</source>
        <translation>所分析数据的长度（至当前）</translation>
    </message>
    <message>
        <source>Time span</source>
        <translation>时间范围</translation>
    </message>
    <message>
        <source>Window function: Hann in general, flat top for exact amplitudes, Blackman-Harris for weak lines near strong ones</source>
        <translation>窗函数：一般用 Hann，精确幅值用平顶，强线旁的弱线用 Blackman-Harris</translation>
    </message>
    <message>
        <source>Amplitude or rms for steady sines; densities for noise, independent of the segment length</source>
        <translation>稳定正弦用幅值或有效值；噪声用谱密度，与分段长度无关</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Signal to analyse; a signal can also be dropped here</source>
        <translation>要分析的信号；也可将信号拖到此处</translation>
    </message>
    <message>
        <source>Summary of the spectrum</source>
        <translation>频谱摘要</translation>
    </message>
    <message>
        <source>Arrow keys move along the lines; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>方向键沿谱线移动；Ctrl+C 复制图片，Ctrl+E 保存</translation>
    </message>
    <message>
        <source>Freeze the spectrum; data acquisition continues</source>
        <translation>冻结频谱；数据采集继续</translation>
    </message>
    <message>
        <source>Live spectrum of a signal. Connect a device: choose one on the left, or try the simulated motor.</source>
        <translation>信号的实时频谱。连接设备：在左侧选择设备，或试用仿真电机。</translation>
    </message>
    <message>
        <source>No data to analyse</source>
        <translation>无可分析的数据</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation>平顶</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>Log frequency</source>
        <translation>频率对数</translation>
    </message>
    <message>
        <source>Logarithmic axis of the frequency</source>
        <translation>频率轴取对数</translation>
    </message>
    <message>
        <source>Log values</source>
        <translation>数值对数</translation>
    </message>
    <message>
        <source>Logarithmic axis of the values</source>
        <translation>数值轴取对数</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>Power density</source>
        <translation>功率谱密度</translation>
    </message>
    <message>
        <source>Amplitude density</source>
        <translation>幅值谱密度</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重叠</translation>
    </message>
    <message>
        <source>Highest peaks</source>
        <translation>最高峰</translation>
    </message>
    <message>
        <source>Peak [Hz]</source>
        <translation>峰 [Hz]</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Value [%1]</source>
        <translation>值 [%1]</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>Save the lines as a table (CSV), in SI units</source>
        <translation>把谱线保存为表（CSV），采用 SI 单位</translation>
    </message>
</context>
<context>
    <name>halbench::app::StopLatch</name>
    <message>
        <source>Wait a moment, check the actuator, then release.</source>
        <translation>请稍候，检查执行器，然后解除。</translation>
    </message>
    <message>
        <source>The stop cannot be released yet.</source>
        <translation>现在还不能解除停止。</translation>
    </message>
</context>
<context>
    <name>halbench::app::TopBar</name>
    <message>
        <source>Release the latched stop; does not arm. Locked shortly after a stop (Space)</source>
        <translation>解除锁存的停止；不会使能。刚停止后锁定（空格键）</translation>
    </message>
    <message>
        <source>device was disarmed</source>
        <translation>设备当时未使能</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>连接丢失</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>连接已断开，正在重连</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>解除</translation>
    </message>
</context>
<context>
    <name>halbench::app::TriggerBar</name>
    <message>
        <source>The device has no hold-off: it re-arms after its capture is read.</source>
        <translation>设备没有释抑：捕获读完后重新准备触发。</translation>
    </message>
    <message>
        <source>The device has no hysteresis: each crossing is an event.</source>
        <translation>设备没有迟滞：每次穿越都是事件。</translation>
    </message>
    <message>
        <source>The device detects one direction only.</source>
        <translation>设备只检测一个方向。</translation>
    </message>
    <message>
        <source>The device waits for its event and shows nothing without it.</source>
        <translation>设备等待事件，无事件则不显示。</translation>
    </message>
    <message>
        <source>Live: searches the plotted samples. %1</source>
        <translation>实时：在所绘样本中查找。%1</translation>
    </message>
    <message>
        <source>Live: searches the plotted samples. Board: the device waits and captures up to 4 plotted signals at its loop rate, 4096 samples</source>
        <translation>实时：在所绘样本中查找。控制板：由设备等待，并以控制回路速率捕获最多 4 个所绘信号，4096 个样本</translation>
    </message>
    <message>
        <source>Not available on the device: computed in the program.</source>
        <translation>设备上没有：在程序中计算。</translation>
    </message>
    <message>
        <source>Event in</source>
        <translation>事件来源</translation>
    </message>
    <message>
        <source>Set the level to the middle of the signal range in view, the hysteresis to 5 % of it</source>
        <translation>将电平设为视图内信号范围的中点，迟滞设为该范围的 5 %</translation>
    </message>
    <message>
        <source>Set level to 50 %</source>
        <translation>设为 50 % 电平</translation>
    </message>
    <message>
        <source>Minimum time between two events</source>
        <translation>两个事件之间的最短时间</translation>
    </message>
    <message>
        <source>Share of the window before the event</source>
        <translation>窗口中事件之前的比例</translation>
    </message>
    <message>
        <source>Pre-trigger</source>
        <translation>预触发</translation>
    </message>
    <message>
        <source>Time span of the triggered view</source>
        <translation>触发视图的时间范围</translation>
    </message>
    <message>
        <source>Distance from the level that re-arms the trigger</source>
        <translation>重新准备触发所需离开电平的距离</translation>
    </message>
    <message>
        <source>Trigger level; the line in the plot can be dragged</source>
        <translation>触发电平；可拖动图中的线</translation>
    </message>
    <message>
        <source>Slope of the trigger edge</source>
        <translation>触发边沿的方向</translation>
    </message>
    <message>
        <source>Signal whose edge is the trigger event, or the set-point</source>
        <translation>以其边沿为触发事件的信号，或设定值</translation>
    </message>
    <message>
        <source>Auto: free-running without events; Normal: waits; Single: stops after one event</source>
        <translation>自动：无事件时自由运行；正常：等待；单次：一个事件后停止</translation>
    </message>
    <message>
        <source>State of the trigger</source>
        <translation>触发状态</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>单次</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>信号源</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>边沿</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>either</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>迟滞</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Hold-off</source>
        <translation>释抑</translation>
    </message>
    <message>
        <source>Set-point change</source>
        <translation>设定值变化</translation>
    </message>
    <message>
        <source>the set-point changes</source>
        <translation>设定值变化</translation>
    </message>
    <message>
        <source>%1 rises through %2</source>
        <translation>%1 上升穿过 %2</translation>
    </message>
    <message>
        <source>%1 falls through %2</source>
        <translation>%1 下降穿过 %2</translation>
    </message>
    <message>
        <source>%1 passes %2</source>
        <translation>%1 穿过 %2</translation>
    </message>
    <message>
        <source>Hysteresis, window and hold-off of the trigger</source>
        <translation>触发的迟滞、窗口和释抑</translation>
    </message>
    <message>
        <source>More settings of the trigger</source>
        <translation>触发的更多设置</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>控制板</translation>
    </message>
    <message>
        <source>Reference start</source>
        <translation>参考启动</translation>
    </message>
    <message>
        <source>the reference starts</source>
        <translation>参考启动</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneForm</name>
    <message>
        <source>From the relay experiment; empty: from the model</source>
        <translation>来自继电实验；留空：来自模型</translation>
    </message>
    <message>
        <source>Largest reference step without current saturation</source>
        <translation>不引起电流饱和的最大参考阶跃</translation>
    </message>
    <message>
        <source>Step height</source>
        <translation>阶跃高度</translation>
    </message>
    <message>
        <source>Current allowed in a step of the height below; at most the device limit</source>
        <translation>下面高度的阶跃允许的电流；至多为设备限值</translation>
    </message>
    <message>
        <source>device limit</source>
        <translation>设备限值</translation>
    </message>
    <message>
        <source>Limit of the sensitivity peak: 1.4 robust, 2 fast. The Numbers page shows whether this limit is active</source>
        <translation>灵敏度峰值的限值：1.4 稳健，2 快速。“数值”页显示此限值是否起作用</translation>
    </message>
    <message>
        <source>Maximum Ms</source>
        <translation>最大 Ms</translation>
    </message>
    <message>
        <source>Target of the design; empty: default of the method</source>
        <translation>设计目标；留空：该方法的默认值</translation>
    </message>
    <message>
        <source>values below</source>
        <translation>下面的数值</translation>
    </message>
    <message>
        <source>Edited manually</source>
        <translation>手动编辑</translation>
    </message>
    <message>
        <source>gains active on the device</source>
        <translation>设备上生效的增益</translation>
    </message>
    <message>
        <source>Device values</source>
        <translation>设备值</translation>
    </message>
    <message>
        <source>Design method, built-in preset or device values</source>
        <translation>设计方法、内置预设或设备值</translation>
    </message>
    <message>
        <source>Source of the gains</source>
        <translation>增益来源</translation>
    </message>
    <message>
        <source>Gain so&amp;urce</source>
        <translation>增益来源(&amp;U)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>请更正或留空</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>方法：%1</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>预设：%1</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>阻尼比</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Bandwidth</source>
        <translation>带宽</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>电流限值</translation>
    </message>
    <message>
        <source>Ultimate gain</source>
        <translation>临界增益</translation>
    </message>
    <message>
        <source>Ultimate period</source>
        <translation>临界周期</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumberWords</name>
    <message>
        <source>not settled after %1</source>
        <translation>%1 后仍未稳定</translation>
    </message>
    <message>
        <source>Time until the angle stays within 10 % of the peak around its final value</source>
        <translation>角度保持在终值附近峰值 10 % 以内所需的时间</translation>
    </message>
    <message>
        <source>longer than the time shown</source>
        <translation>超过所示时间</translation>
    </message>
    <message>
        <source>Settling after load</source>
        <translation>负载后的恢复时间</translation>
    </message>
    <message>
        <source>Largest deviation of the linear loop after the load step</source>
        <translation>负载阶跃后线性回路的最大偏差</translation>
    </message>
    <message>
        <source>Peak after a load step equal to %1 A</source>
        <translation>相当于 %1 A 的负载阶跃后的峰值</translation>
    </message>
    <message>
        <source>Verification after each step: %1 forth and back in %2. Device stops at %3 or %4.</source>
        <translation>每一步后验证：来回 %1，用时 %2。设备在 %3 或 %4 处停止。</translation>
    </message>
    <message>
        <source>Verification: %1 in %2. Device stops at %3 or %4.</source>
        <translation>验证：%1，用时 %2。设备在 %3 或 %4 处停止。</translation>
    </message>
    <message>
        <source>Smaller oscillations decay</source>
        <translation>更小的振荡会衰减</translation>
    </message>
    <message>
        <source>Growth threshold</source>
        <translation>增长阈值</translation>
    </message>
    <message>
        <source>Harmonic balance does not cover the micro-step assist or a motor without friction</source>
        <translation>谐波平衡不适用于微步辅助和无摩擦的电机</translation>
    </message>
    <message>
        <source>Sustained oscillation due to friction and current limit (harmonic balance)</source>
        <translation>摩擦和电流限制引起的持续振荡（谐波平衡）</translation>
    </message>
    <message>
        <source>From half the friction band. The rotor then jumps and may stick again (hunting)</source>
        <translation>从半个摩擦带处算起。之后转子跳动并可能再次停住（游荡）</translation>
    </message>
    <message>
        <source>Stick time before integral moves it</source>
        <translation>积分起动前的静止时间</translation>
    </message>
    <message>
        <source>Stability of the loop with one more sample of delay</source>
        <translation>时延增加一个采样时回路的稳定性</translation>
    </message>
    <message>
        <source>One sample more delay</source>
        <translation>时延增加一个采样</translation>
    </message>
    <message>
        <source>Larger steps reach the current limit</source>
        <translation>更大的阶跃会达到电流限值</translation>
    </message>
    <message>
        <source>Largest step without saturation</source>
        <translation>不饱和的最大阶跃</translation>
    </message>
    <message>
        <source>Current noise per radian of angle noise</source>
        <translation>每弧度角度噪声引起的电流噪声</translation>
    </message>
    <message>
        <source>Maximum amplification of disturbances; usually at most 2</source>
        <translation>扰动的最大放大倍数；通常至多为 2</translation>
    </message>
    <message>
        <source>Sensitivity peak Ms</source>
        <translation>灵敏度峰值 Ms</translation>
    </message>
    <message>
        <source>Active limit: it prevents a smaller error after a load step</source>
        <translation>起作用的限值：它使负载阶跃后的误差无法更小</translation>
    </message>
    <message>
        <source>%1: limit active</source>
        <translation>%1：限值起作用</translation>
    </message>
    <message>
        <source>max. deviation from the prediction %1 at %2 s</source>
        <translation>与预测的最大偏差 %1，在 %2 s</translation>
    </message>
    <message>
        <source>overshoot %1 % (%2 % above the limit)</source>
        <translation>超调 %1 %（超出限值 %2 %）</translation>
    </message>
    <message>
        <source>final error %1 (%2 above the limit)</source>
        <translation>最终误差 %1（超出限值 %2）</translation>
    </message>
    <message>
        <source>final error %1 (limit %2)</source>
        <translation>最终误差 %1（限值 %2）</translation>
    </message>
    <message>
        <source>Possible standstill error due to friction</source>
        <translation>摩擦引起的可能静态误差</translation>
    </message>
    <message>
        <source>Stability limit of the sampled loop</source>
        <translation>采样回路的稳定界限</translation>
    </message>
    <message>
        <source>Smallest distance of the open loop from -1; usually at least 0.5</source>
        <translation>开环到 -1 的最小距离；通常至少 0.5</translation>
    </message>
    <message>
        <source>Additional delay at the stability limit</source>
        <translation>稳定界限处的附加时延</translation>
    </message>
    <message>
        <source>Frequency at which the open-loop gain is 1</source>
        <translation>开环增益为 1 的频率</translation>
    </message>
    <message>
        <source>Share of the motors within the model&apos;s uncertainty for which this loop is unstable</source>
        <translation>模型不确定度范围内使此回路不稳定的电机比例</translation>
    </message>
    <message>
        <source>Share of unstable cases</source>
        <translation>不稳定情况的比例</translation>
    </message>
    <message>
        <source>Phase margin at the gain crossover; usually at least 30°</source>
        <translation>增益穿越频率处的相位裕度；通常至少 30°</translation>
    </message>
    <message>
        <source>Gain factor at the stability limit; usually at least 2</source>
        <translation>稳定界限处的增益倍数；通常至少为 2</translation>
    </message>
    <message>
        <source>Poles of the sampled loop, with the device&apos;s delay</source>
        <translation>采样回路的极点，含设备时延</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>无穷大</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>闭环</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>UNSTABLE</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>Gain crossover</source>
        <translation>增益穿越频率</translation>
    </message>
    <message>
        <source>Delay margin</source>
        <translation>时延裕度</translation>
    </message>
    <message>
        <source>Modulus margin</source>
        <translation>模裕度</translation>
    </message>
    <message>
        <source>Largest K_P</source>
        <translation>最大 K_P</translation>
    </message>
    <message>
        <source>Friction band at rest</source>
        <translation>静止摩擦带</translation>
    </message>
    <message>
        <source>Linear step</source>
        <translation>线性阶跃</translation>
    </message>
    <message>
        <source>Small steps, without friction and current limit</source>
        <translation>小阶跃，无摩擦和电流限制</translation>
    </message>
    <message>
        <source>With friction and current limit</source>
        <translation>含摩擦和电流限制</translation>
    </message>
    <message>
        <source>Step of %1</source>
        <translation>%1 阶跃</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Current in a step of %1</source>
        <translation>%1 阶跃的电流</translation>
    </message>
    <message>
        <source>Noise gain</source>
        <translation>噪声增益</translation>
    </message>
    <message>
        <source>stays stable</source>
        <translation>仍然稳定</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, to %3 %</source>
        <translation>%1，%2 Hz，精度 %3 %</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>%1 s 之后</translation>
    </message>
    <message>
        <source>never</source>
        <translation>永不</translation>
    </message>
    <message>
        <source>Limit cycle</source>
        <translation>极限环</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not predicted</source>
        <translation>未预测</translation>
    </message>
    <message>
        <source>%1: rise time</source>
        <translation>%1：上升时间</translation>
    </message>
    <message>
        <source>%1: overshoot</source>
        <translation>%1：超调</translation>
    </message>
    <message>
        <source>%1: settling time (2 %)</source>
        <translation>%1：调节时间(2 %)</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>已稳定</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumbers</name>
    <message>
        <source>Range over the uncertainty of the identified motor</source>
        <translation>已辨识电机不确定度对应的范围</translation>
    </message>
    <message>
        <source>5-95 % band</source>
        <translation>5-95 % 范围</translation>
    </message>
    <message>
        <source>Before applying</source>
        <translation>应用之前</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>On the device</source>
        <translation>设备中</translation>
    </message>
    <message>
        <source>Predicted figures</source>
        <translation>预测指标</translation>
    </message>
</context>
<context>
    <name>halbench::app::TunePanel</name>
    <message>
        <source>Use %1</source>
        <translation>使用 %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Motor (SI, 95 %): %1</source>
        <translation>电机（SI，95 %）：%1</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Measured move and prediction, after Apply and verify</source>
        <translation>实测运动与预测，在“应用并验证”之后</translation>
    </message>
    <message>
        <source>What-if</source>
        <translation>假设分析</translation>
    </message>
    <message>
        <source>Replay of a recorded move with the proposed gains</source>
        <translation>用建议的增益回放已记录的运动</translation>
    </message>
</context>
<context>
    <name>halbench::app::TunePages</name>
    <message>
        <source>Tuning is not available for this device</source>
        <translation>此设备不支持整定</translation>
    </message>
    <message numerus="yes">
        <source>%n control loop(s), no identification procedure. Edit the gains in Parameters and check them with a reference in Drive.</source>
        <translation>
            <numerusform>%n 个控制回路，没有辨识流程。请在“参数”中编辑增益，并在“驱动”中用参考信号检查。</numerusform>
        </translation>
    </message>
    <message>
        <source>No axes to tune yet</source>
        <translation>尚无可整定的轴</translation>
    </message>
    <message>
        <source>Gains are designed for identified axes and verified by a step of each axis before they are kept.</source>
        <translation>增益针对已辨识的轴设计，并在保留之前用各轴的阶跃验证。</translation>
    </message>
    <message>
        <source>Identify the axes</source>
        <translation>辨识各轴</translation>
    </message>
    <message>
        <source>No motor to tune</source>
        <translation>没有可整定的电机</translation>
    </message>
    <message>
        <source>Gains are designed for an identified motor and verified by a move before they are kept.</source>
        <translation>针对已辨识的电机设计增益，并在保留前通过一次运动验证。</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>辨识电机</translation>
    </message>
</context>
<context>
    <name>halbench::app::ApplyControls</name>
    <message>
        <source>Verification: %1</source>
        <translation>验证：%1</translation>
    </message>
    <message>
        <source>Verification running</source>
        <translation>正在验证</translation>
    </message>
    <message>
        <source>Writing the gains</source>
        <translation>正在写入增益</translation>
    </message>
    <message>
        <source>These gains cannot be applied: %1. %2.</source>
        <translation>这些增益不能应用：%1。%2。</translation>
    </message>
    <message>
        <source>Relative to the start position of the rotor</source>
        <translation>相对于转子的起始位置</translation>
    </message>
    <message>
        <source>Apply and verify</source>
        <translation>应用并验证</translation>
    </message>
    <message>
        <source>Write all gains together, then verify with a step; Esc stops it</source>
        <translation>一次写入全部增益，然后用阶跃验证；按 Esc 停止</translation>
    </message>
    <message>
        <source>Apply gradually</source>
        <translation>逐步应用</translation>
    </message>
    <message>
        <source>Change K_P and K_P + K_D/T by at most half in each step. Each step is assessed before writing and verified by a move; on failure the previous gains are restored</source>
        <translation>每步使 K_P 和 K_P + K_D/T 至多变化一半。每步写入前先评估，并通过一次运动验证；失败时恢复之前的增益</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>New gains active until power-off (simulated: until disconnect). To keep them: Save to device, in the Parameters panel</source>
        <translation>新增益在断电前（仿真：断开前）有效。如需保留：在“参数”面板中选择“保存到设备”</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Restore the previous gains</source>
        <translation>恢复之前的增益</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignComparison</name>
    <message>
        <source>not assessed: project entry cannot be read</source>
        <translation>未评估：无法读取项目条目</translation>
    </message>
    <message>
        <source>not assessed yet</source>
        <translation>尚未评估</translation>
    </message>
    <message>
        <source>not assessed: %1</source>
        <translation>未评估：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainDecision</name>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Not kept, previous gains restored: %1</source>
        <translation>未保留，已恢复之前的增益：%1</translation>
    </message>
    <message>
        <source>Cancelled. Previous gains restored.</source>
        <translation>已取消。已恢复之前的增益。</translation>
    </message>
    <message>
        <source>Applied and verified: the move matched the prediction.</source>
        <translation>已应用并验证：运动与预测一致。</translation>
    </message>
    <message>
        <source>Keep the new gains, or restore the previous ones.</source>
        <translation>请保留新增益，或恢复之前的增益。</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>To keep them: Save to device, in the Parameters panel.</source>
        <translation>如需保留：在“参数”面板中选择“保存到设备”。</translation>
    </message>
    <message>
        <source>kept on %1</source>
        <translation>已保留于 %1</translation>
    </message>
    <message>
        <source>They are saved as design &apos;%1&apos; and can be applied again.</source>
        <translation>已存为设计“%1”，可再次应用。</translation>
    </message>
    <message>
        <source>They are saved as design &apos;%1&apos;.</source>
        <translation>已存为设计“%1”。</translation>
    </message>
    <message>
        <source>New gains active until disconnect.</source>
        <translation>新增益在断开前有效。</translation>
    </message>
    <message>
        <source>New gains active until power-off.</source>
        <translation>新增益在断电前有效。</translation>
    </message>
    <message>
        <source>Previous gains restored.</source>
        <translation>已恢复之前的增益。</translation>
    </message>
    <message>
        <source>applied on %1</source>
        <translation>已应用于 %1</translation>
    </message>
    <message>
        <source>Gains applied on %1 were neither kept nor restored.</source>
        <translation>应用于 %1 的增益既未保留也未恢复。</translation>
    </message>
    <message>
        <source>%1 was disconnected with the kept gains.</source>
        <translation>%1 已断开，保留的增益在该设备上。</translation>
    </message>
    <message>
        <source>A simulated device is reset on disconnect.</source>
        <translation>仿真设备在断开时复位。</translation>
    </message>
    <message>
        <source>They stay active until power-off.</source>
        <translation>断电前仍然有效。</translation>
    </message>
    <message>
        <source>They are saved as design &apos;%1&apos;. To use them: Use this design, then Apply and verify.</source>
        <translation>已存为设计“%1”。使用方法：先“使用此设计”，再“应用并验证”。</translation>
    </message>
    <message>
        <source>Drive the motor</source>
        <translation>驱动电机</translation>
    </message>
    <message>
        <source>Open Parameters</source>
        <translation>打开“参数”</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainFiles</name>
    <message>
        <source>Open gains</source>
        <translation>打开增益</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>增益 (*.json)</translation>
    </message>
    <message>
        <source>Gains of %1.</source>
        <translation>来自 %1 的增益。</translation>
    </message>
    <message>
        <source>Save gains</source>
        <translation>保存增益</translation>
    </message>
    <message>
        <source>Gains (*.json);;Control law as C code (*.c)</source>
        <translation>增益 (*.json);;C 代码控制律 (*.c)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>Save gains…</source>
        <translation>保存增益…</translation>
    </message>
    <message>
        <source>Save gains to a file</source>
        <translation>将增益保存到文件</translation>
    </message>
    <message>
        <source>Open gains…</source>
        <translation>打开增益…</translation>
    </message>
    <message>
        <source>Use the gains of a file as proposed gains; they are assessed before they can be applied</source>
        <translation>将文件中的增益用作建议增益；应用前先评估</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainHistoryActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainSettings</name>
    <message>
        <source>Gains from the project: %1.</source>
        <translation>来自项目的增益：%1。</translation>
    </message>
    <message>
        <source>Choose a method to design new gains for the present motor model.</source>
        <translation>选择一种方法，为当前电机模型设计新的增益。</translation>
    </message>
    <message>
        <source>Gain source: %1</source>
        <translation>增益来源：%1</translation>
    </message>
    <message>
        <source>Edit the gains</source>
        <translation>编辑增益</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>编辑 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopShaping</name>
    <message>
        <source>Move a pole</source>
        <translation>移动极点</translation>
    </message>
    <message>
        <source>Move the crossover</source>
        <translation>移动穿越频率</translation>
    </message>
    <message>
        <source>Move the phase margin</source>
        <translation>移动相位裕度</translation>
    </message>
    <message>
        <source>More gain would be unstable: limited.</source>
        <translation>增益再大则不稳定：已限制。</translation>
    </message>
</context>
<context>
    <name>halbench::app::MeasuredOverlay</name>
    <message>
        <source>Open a measured response</source>
        <translation>打开测得的响应</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>频率响应 (*.json)</translation>
    </message>
    <message>
        <source>Measured response shown in the open loop, with the proposed gains.</source>
        <translation>测得的响应已显示在开环图中，采用建议的增益。</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies are coherent; the others are hollow.</source>
        <translation>%2 个频率中有 %1 个相干；其余为空心点。</translation>
    </message>
    <message>
        <source>Remove the response</source>
        <translation>移除频率响应</translation>
    </message>
    <message>
        <source>Measured response…</source>
        <translation>测得的响应…</translation>
    </message>
    <message>
        <source>Show only predictions in the open loop</source>
        <translation>开环图中只显示预测</translation>
    </message>
    <message>
        <source>Show the response measured with identify --frequency in the open loop, with the proposed gains (no motor model)</source>
        <translation>在开环图中显示 identify --frequency 测得的响应，采用建议的增益（不含电机模型）</translation>
    </message>
</context>
<context>
    <name>halbench::app::PredictionPages</name>
    <message>
        <source>Open loop</source>
        <translation>开环</translation>
    </message>
    <message>
        <source>Bode, Nyquist and Nichols plot, and sensitivity</source>
        <translation>Bode 图、Nyquist 图、Nichols 图和灵敏度</translation>
    </message>
    <message>
        <source>Step of %1</source>
        <translation>%1 阶跃</translation>
    </message>
    <message>
        <source>A large step with friction and current limit</source>
        <translation>带摩擦和电流限制的大阶跃</translation>
    </message>
    <message>
        <source>Small step</source>
        <translation>小阶跃</translation>
    </message>
    <message>
        <source>Step of the linear loop</source>
        <translation>线性回路的阶跃</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>Effect of a load step on the angle</source>
        <translation>负载阶跃对角度的影响</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>All predicted figures, margins with intervals</source>
        <translation>所有预测指标，裕度附区间</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Saved designs, compared with the proposed gains</source>
        <translation>已保存的设计，与建议的增益比较</translation>
    </message>
    <message>
        <source>Predictions</source>
        <translation>预测</translation>
    </message>
</context>
<context>
    <name>halbench::app::VerificationPage</name>
    <message>
        <source>No verification yet</source>
        <translation>尚未验证</translation>
    </message>
    <message>
        <source>Within the predicted band (gains no longer active)</source>
        <translation>在预测范围内（增益已不再生效）</translation>
    </message>
    <message>
        <source>Within the predicted band (applied gains, not those shown)</source>
        <translation>在预测范围内（指已应用的增益，而非显示的增益）</translation>
    </message>
    <message>
        <source>Within the predicted band</source>
        <translation>在预测范围之内</translation>
    </message>
    <message>
        <source>Outside the predicted band</source>
        <translation>超出预测范围</translation>
    </message>
    <message>
        <source>Outside the predicted band (applied gains, not those shown)</source>
        <translation>超出预测范围（指已应用的增益，而非显示的增益）</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfRecording</name>
    <message>
        <source>Open a recorded move</source>
        <translation>打开记录的运动</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>记录 (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Open the active gains of the recording</source>
        <translation>打开记录时生效的增益</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>增益 (*.json)</translation>
    </message>
    <message>
        <source>The recording is shown after a motor is identified.</source>
        <translation>辨识电机后显示该记录。</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>What-if: %1</source>
        <translation>假设分析：%1</translation>
    </message>
    <message>
        <source>Choose the file with the gains that were active during the recording.</source>
        <translation>请选择记录时生效的增益文件。</translation>
    </message>
    <message>
        <source>Recorded gains…</source>
        <translation>记录时的增益…</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuningFigures</name>
    <message>
        <source>Load step equal to %1 A, linear model</source>
        <translation>相当于 %1 A 的负载阶跃，线性模型</translation>
    </message>
    <message>
        <source>%1 encirclements; unstable poles of L: %2</source>
        <translation>绕 %1 圈；L 的不稳定极点：%2</translation>
    </message>
    <message>
        <source>settling time</source>
        <translation>恢复时间</translation>
    </message>
    <message>
        <source>90 % band</source>
        <translation>90 % 范围</translation>
    </message>
    <message>
        <source>5-95 % band (motor uncertainty)</source>
        <translation>5-95 % 范围（电机不确定度）</translation>
    </message>
    <message>
        <source>measured, low coherence</source>
        <translation>实测，相干性低</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>开环</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>response</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>friction band</source>
        <translation>摩擦带</translation>
    </message>
    <message>
        <source>Predicted step with friction and current limit,</source>
        <translation>预测阶跃（含摩擦和电流限制），</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Verification move</source>
        <translation>验证运动</translation>
    </message>
    <message>
        <source>Predicted step of %1, linear loop</source>
        <translation>预测的 %1 阶跃，线性回路</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>allowed %1</source>
        <translation>允许 %1</translation>
    </message>
    <message>
        <source>friction band %1</source>
        <translation>摩擦带 %1</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>with the proposed gains</source>
        <translation>采用建议的增益</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Recorded move</source>
        <translation>记录的运动</translation>
    </message>
    <message>
        <source>angle from the reference</source>
        <translation>相对参考值的角度</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>峰值</translation>
    </message>
    <message>
        <source>other crossings</source>
        <translation>其他穿越</translation>
    </message>
</context>
<context>
    <name>halbench::app::UnsavedBar</name>
    <message>
        <source>Continue; unsaved changes are lost</source>
        <translation>继续；未保存的更改将丢失</translation>
    </message>
    <message>
        <source>Save to another place, then continue</source>
        <translation>另存到别处，然后继续</translation>
    </message>
    <message>
        <source>Try to save again, then continue</source>
        <translation>再次保存，然后继续</translation>
    </message>
    <message>
        <source>The project stays open because saving failed: %1</source>
        <translation>保存失败，项目保持打开：%1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>项目另存为…</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfPage</name>
    <message>
        <source>The proposed gains equal the recorded gains: the recording shows their result.</source>
        <translation>建议的增益与记录时的增益相同：记录即为其结果。</translation>
    </message>
    <message>
        <source>%1 % of the recorded motion are outside the band of the recorded gains.</source>
        <translation>记录的运动有 %1 % 超出记录时增益的范围。</translation>
    </message>
    <message>
        <source>%1: doubtful, see below</source>
        <translation>%1：存疑，见下文</translation>
    </message>
    <message>
        <source>%1: the identified model matches the recorded move</source>
        <translation>%1：辨识模型与记录的运动相符</translation>
    </message>
    <message>
        <source>%1: identify the motor first</source>
        <translation>%1：请先辨识电机</translation>
    </message>
    <message>
        <source>Assessing %1</source>
        <translation>正在评估 %1</translation>
    </message>
    <message>
        <source>%1: no prediction for the proposed gains</source>
        <translation>%1：没有建议增益的预测</translation>
    </message>
    <message>
        <source>Clear this page; the recording is kept</source>
        <translation>清空此页；保留记录</translation>
    </message>
    <message>
        <source>What-if: replay a recorded move with the proposed gains. Needs an identified motor that matches the recording.</source>
        <translation>假设分析：用建议的增益回放已记录的运动。需要与记录相符的已辨识电机。</translation>
    </message>
    <message>
        <source>No recording selected</source>
        <translation>未选择记录</translation>
    </message>
    <message>
        <source>Open a recorded move</source>
        <translation>打开记录的运动</translation>
    </message>
    <message>
        <source>Another move…</source>
        <translation>另一次运动…</translation>
    </message>
    <message>
        <source>Choose another recording</source>
        <translation>选择另一个记录</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfWords</name>
    <message>
        <source>With the proposed gains: overshoot %1 instead of %2, final error %3 instead of %4.</source>
        <translation>采用建议的增益：超调 %1（原为 %2），最终误差 %3（原为 %4）。</translation>
    </message>
    <message>
        <source>No prediction for the proposed gains: %1</source>
        <translation>没有建议增益的预测：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::WizardPanel</name>
    <message>
        <source>Connect a device, or wait until the running task ends.</source>
        <translation>请连接设备，或等待运行中的任务结束。</translation>
    </message>
    <message>
        <source>Not started: no device connected, or the device is busy.</source>
        <translation>未启动：没有连接设备，或设备忙。</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::XyPanel</name>
    <message>
        <source>rms residual of the ellipse %1 % of the amplitude</source>
        <translation>椭圆的均方根残差为幅值的 %1 %</translation>
    </message>
    <message>
        <source>Semi-axes %1 and %2 %3</source>
        <translation>半轴 %1 和 %2 %3</translation>
    </message>
    <message>
        <source>Phase error from 90°</source>
        <translation>相对 90° 的相位误差</translation>
    </message>
    <message>
        <source>Amplitude ratio</source>
        <translation>幅值比</translation>
    </message>
    <message>
        <source>Fit an ellipse to the points; needs several turns (Alt+E)</source>
        <translation>对各点拟合椭圆；需要多圈数据 (Alt+E)</translation>
    </message>
    <message>
        <source>Length of the data shown, up to now</source>
        <translation>所显示数据的长度（至当前）</translation>
    </message>
    <message>
        <source>Time span</source>
        <translation>时间范围</translation>
    </message>
    <message>
        <source>Signal of the vertical axis; a signal can also be dropped here</source>
        <translation>纵轴信号；也可将信号拖到此处</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Signal of the horizontal axis; a signal can also be dropped here</source>
        <translation>横轴信号；也可将信号拖到此处</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Summary of the ellipse</source>
        <translation>椭圆摘要</translation>
    </message>
    <message>
        <source>Arrow keys move along the points; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>方向键沿各点移动；Ctrl+C 复制图片，Ctrl+E 保存</translation>
    </message>
    <message>
        <source>Two signals plotted against each other, initially the Hall sensors with their ellipse. Connect a device: choose one on the left, or try the simulated motor.</source>
        <translation>两个信号的关系图，初始为霍尔传感器及其椭圆。连接设备：在左侧选择设备，或试用仿真电机。</translation>
    </message>
    <message>
        <source>No data to show</source>
        <translation>无可显示的数据</translation>
    </message>
    <message>
        <source>Fitted ellipse</source>
        <translation>拟合椭圆</translation>
    </message>
    <message>
        <source>Ellip&amp;se</source>
        <translation>椭圆(&amp;S)</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 对 %2</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Centre of %1</source>
        <translation>%1 的中心</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>%1 的幅值</translation>
    </message>
    <message>
        <source>Save all points as a table (CSV), in SI units</source>
        <translation>把所有点保存为表（CSV），采用 SI 单位</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::BandItem</name>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::CursorBar</name>
    <message>
        <source>Active pair: %1. N adds a pair, P selects the next, F2 names it; the others are faint</source>
        <translation>活动光标对：%1。N 添加，P 选择下一对，F2 命名；其余淡显</translation>
    </message>
    <message>
        <source>Name of the active pair; named pairs are saved in the project (F2)</source>
        <translation>活动光标对的名称；已命名的光标对随项目保存（F2）</translation>
    </message>
    <message>
        <source>Active pair</source>
        <translation>活动光标对</translation>
    </message>
    <message>
        <source>Time of cursor %1: type it, drag the line, or press %1 and the arrow keys</source>
        <translation>光标 %1 的时间：直接输入、拖动竖线，或按 %1 键后用方向键</translation>
    </message>
    <message>
        <source>Time of cursor %1</source>
        <translation>光标 %1 的时间</translation>
    </message>
    <message>
        <source>Distance of the cursors</source>
        <translation>光标间距</translation>
    </message>
    <message>
        <source>Δt %1 s    1/Δt %2 Hz</source>
        <translation>Δt %1 s    1/Δt %2 Hz</translation>
    </message>
    <message>
        <source>Cursor pair</source>
        <translation>光标对</translation>
    </message>
    <message>
        <source>Name of the cursor pair</source>
        <translation>光标对的名称</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::EmptyState</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::EstimateTable</name>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>± (95 %)</source>
        <translation>± (95 %)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>95 % interval: %1 to %2</source>
        <translation>95 % 区间：%1 至 %2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::FigureProbe</name>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 从 %2 到 %3</translation>
    </message>
    <message>
        <source>Against %1: %2</source>
        <translation>相对于%1：%2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::FigureView</name>
    <message>
        <source>No data to show</source>
        <translation>无可显示的数据</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Drag: %1</source>
        <translation>拖动：%1</translation>
    </message>
    <message>
        <source>Ctrl and the arrow keys move: %1.</source>
        <translation>Ctrl 加方向键移动：%1。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::Figures</name>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>估计值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LegendTableModel</name>
    <message>
        <source>%1: %2 %3%4</source>
        <translation>%1：%2 %3%4</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>%1 (right)</source>
        <translation>%1（右）</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LiveLegend</name>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Move to</source>
        <translation>移到</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>复制数值</translation>
    </message>
    <message>
        <source>Space hides or shows the curve, F2 renames it, R changes its axis, U its unit, Ctrl with an arrow key moves it to the next plot, Ctrl+Shift+Down to a new plot, Ctrl+Shift+Right to a new plot beside, Delete removes it.</source>
        <translation>空格键隐藏或显示曲线，F2 重命名，R 更换坐标轴，U 更换单位，Ctrl 加方向键移到相邻曲线图，Ctrl+Shift+下移到新曲线图，Ctrl+Shift+右移到旁边的新曲线图，Delete 移除。</translation>
    </message>
    <message>
        <source>New plot on the right</source>
        <translation>在右侧新建曲线图</translation>
    </message>
    <message>
        <source>Plot on the right</source>
        <translation>右边的曲线图</translation>
    </message>
    <message>
        <source>Plot on the left</source>
        <translation>左边的曲线图</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>新建曲线图</translation>
    </message>
    <message>
        <source>Plot below</source>
        <translation>下方的曲线图</translation>
    </message>
    <message>
        <source>Plot above</source>
        <translation>上方的曲线图</translation>
    </message>
    <message>
        <source>Use right axis</source>
        <translation>使用右轴</translation>
    </message>
    <message>
        <source>Use left axis</source>
        <translation>使用左轴</translation>
    </message>
    <message>
        <source>Selected curve</source>
        <translation>所选曲线</translation>
    </message>
    <message>
        <source>Legend with live values</source>
        <translation>带实时数值的图例</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Remove from the plot</source>
        <translation>从曲线图中移除</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlot</name>
    <message>
        <source>Arrow keys move a cursor or scroll, plus and minus zoom the time (Ctrl: the values), Space pauses, F fits, Insert adds signals.</source>
        <translation>方向键移动光标或滚动，加减号缩放时间（Ctrl：数值），空格键暂停，F 适应，Insert 添加信号。</translation>
    </message>
    <message>
        <source>Plot of %1, right axis %2</source>
        <translation>%1 的曲线图，右轴 %2</translation>
    </message>
    <message>
        <source>Drag signals here or press Insert</source>
        <translation>将信号拖到此处或按 Insert 键</translation>
    </message>
    <message>
        <source>Empty plot</source>
        <translation>空曲线图</translation>
    </message>
    <message>
        <source>Plot of %1</source>
        <translation>%1的曲线图</translation>
    </message>
    <message>
        <source>%1, column %2</source>
        <translation>%1，第 %2 列</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlotStack</name>
    <message>
        <source>Own time axis, %1 s</source>
        <translation>独立时间轴，%1 s</translation>
    </message>
    <message>
        <source>Recorded data, %1 s</source>
        <translation>已记录的数据，%1 s</translation>
    </message>
    <message>
        <source>Paused for %1 s</source>
        <translation>已暂停 %1 s</translation>
    </message>
    <message>
        <source>Equal widths and heights for all plots</source>
        <translation>所有曲线图等宽等高</translation>
    </message>
    <message>
        <source>Reduce the column width</source>
        <translation>减小列宽</translation>
    </message>
    <message>
        <source>Increase the column width</source>
        <translation>增大列宽</translation>
    </message>
    <message>
        <source>Reduce the plot height</source>
        <translation>减小曲线图高度</translation>
    </message>
    <message>
        <source>Increase the plot height</source>
        <translation>增大曲线图高度</translation>
    </message>
    <message>
        <source>Fit the value axes of the focused plot to its data</source>
        <translation>使当前曲线图的数值轴适应其数据</translation>
    </message>
    <message>
        <source>Zoom out the values of the focused plot</source>
        <translation>缩小当前曲线图的数值</translation>
    </message>
    <message>
        <source>Zoom in the values of the focused plot</source>
        <translation>放大当前曲线图的数值</translation>
    </message>
    <message>
        <source>All markers with their notes</source>
        <translation>全部标记及其备注</translation>
    </message>
    <message>
        <source>Remove the selected marker</source>
        <translation>移除所选标记</translation>
    </message>
    <message>
        <source>Select the previous marker and show it</source>
        <translation>选择上一个标记并显示</translation>
    </message>
    <message>
        <source>Select the next marker and show it</source>
        <translation>选择下一个标记并显示</translation>
    </message>
    <message>
        <source>Edit the note of the selected marker, of the marker at this time, or of a new one</source>
        <translation>编辑所选标记、此刻标记或新标记的备注</translation>
    </message>
    <message>
        <source>Remove the plot with its curves</source>
        <translation>移除该曲线图及其曲线</translation>
    </message>
    <message>
        <source>Empty plot in a new column</source>
        <translation>在新的一列中新建空曲线图</translation>
    </message>
    <message>
        <source>New plot on the right</source>
        <translation>在右侧新建曲线图</translation>
    </message>
    <message>
        <source>Move the plot to the column on the left, or to a new column</source>
        <translation>将曲线图移到左边一列或新的一列</translation>
    </message>
    <message>
        <source>Move the plot to the column on the right, or to a new column</source>
        <translation>将曲线图移到右边一列或新的一列</translation>
    </message>
    <message>
        <source>Use the common time axis in all plots</source>
        <translation>所有曲线图使用公共时间轴</translation>
    </message>
    <message>
        <source>Zoom and scroll this plot separately; again: with the others</source>
        <translation>单独缩放和滚动此曲线图；再按一次：与其他联动</translation>
    </message>
    <message>
        <source>Own time axis, paused in history (End: live)</source>
        <translation>独立时间轴，停在历史中（End：实时）</translation>
    </message>
    <message>
        <source>Pair %1 exists already. Name unchanged: %2</source>
        <translation>已有光标对 %1。名称未变：%2</translation>
    </message>
    <message>
        <source>A pair needs a name. Name unchanged: %1</source>
        <translation>光标对需要名称。名称未变：%1</translation>
    </message>
    <message>
        <source>Move the active pair into view</source>
        <translation>将活动光标对移入视图</translation>
    </message>
    <message>
        <source>Show the time around the active pair</source>
        <translation>显示活动光标对周围的时间</translation>
    </message>
    <message>
        <source>Name of the active pair; saved in the project</source>
        <translation>活动光标对的名称；随项目保存</translation>
    </message>
    <message>
        <source>Activate the previous pair</source>
        <translation>激活上一对光标</translation>
    </message>
    <message>
        <source>Activate the next pair</source>
        <translation>激活下一对光标</translation>
    </message>
    <message>
        <source>Remove the active pair</source>
        <translation>移除活动光标对</translation>
    </message>
    <message>
        <source>Add two cursors; the other pairs stay, faint</source>
        <translation>添加两个光标；其他光标对保留并淡显</translation>
    </message>
    <message>
        <source>previous curves</source>
        <translation>之前的曲线</translation>
    </message>
    <message>
        <source>Remove the faint reference curves</source>
        <translation>移除浅色参考曲线</translation>
    </message>
    <message>
        <source>Keep the present curves as faint reference below the live curves</source>
        <translation>将当前曲线保留为实时曲线下方的浅色参考</translation>
    </message>
    <message>
        <source>Triggered view (End: live)</source>
        <translation>触发视图（End：实时）</translation>
    </message>
    <message>
        <source>Paused in history (End: live)</source>
        <translation>停在历史中（End：实时）</translation>
    </message>
    <message>
        <source>Choose the signals to plot</source>
        <translation>选择要绘制的信号</translation>
    </message>
    <message>
        <source>Add a marker at this time</source>
        <translation>在此刻添加标记</translation>
    </message>
    <message>
        <source>Two measuring cursors; drag them or use the arrow keys</source>
        <translation>两个测量光标；拖动或用方向键移动</translation>
    </message>
    <message>
        <source>Show later data</source>
        <translation>显示更晚的数据</translation>
    </message>
    <message>
        <source>Scroll forward</source>
        <translation>向前滚动</translation>
    </message>
    <message>
        <source>Show earlier data</source>
        <translation>显示更早的数据</translation>
    </message>
    <message>
        <source>Show a longer time span</source>
        <translation>显示较长的时间范围</translation>
    </message>
    <message>
        <source>Show a shorter time span</source>
        <translation>显示较短的时间范围</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>上一个视图</translation>
    </message>
    <message>
        <source>Show the whole history</source>
        <translation>显示全部历史</translation>
    </message>
    <message>
        <source>Fit the value axes; in a paused view, show the whole history</source>
        <translation>适应数值轴；视图暂停时显示全部历史</translation>
    </message>
    <message>
        <source>Keep the latest sample in view</source>
        <translation>保持最新样本可见</translation>
    </message>
    <message>
        <source>Pause view (recording continues)</source>
        <translation>暂停视图（记录继续）</translation>
    </message>
    <message>
        <source>Live values of %1</source>
        <translation>%1的实时数值</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>返回缩放</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Scroll back</source>
        <translation>向后滚动</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Cursor A</source>
        <translation>光标 A</translation>
    </message>
    <message>
        <source>Arrow keys move cursor A</source>
        <translation>方向键移动光标 A</translation>
    </message>
    <message>
        <source>Cursor B</source>
        <translation>光标 B</translation>
    </message>
    <message>
        <source>Arrow keys move cursor B</source>
        <translation>方向键移动光标 B</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Add signals</source>
        <translation>添加信号</translation>
    </message>
    <message>
        <source>Following, %1 s</source>
        <translation>跟随中，%1 s</translation>
    </message>
    <message>
        <source>Keep as reference</source>
        <translation>保留为参考</translation>
    </message>
    <message>
        <source>Remove the reference</source>
        <translation>移除参考</translation>
    </message>
    <message>
        <source>Remove the reference: %1</source>
        <translation>移除参考：%1</translation>
    </message>
    <message>
        <source>New cursor pair</source>
        <translation>新建光标对</translation>
    </message>
    <message>
        <source>Remove the cursor pair</source>
        <translation>移除光标对</translation>
    </message>
    <message>
        <source>Next cursor pair</source>
        <translation>下一对光标</translation>
    </message>
    <message>
        <source>Previous cursor pair</source>
        <translation>上一对光标</translation>
    </message>
    <message>
        <source>Name the cursor pair</source>
        <translation>命名光标对</translation>
    </message>
    <message>
        <source>Go to the cursor pair</source>
        <translation>转到光标对</translation>
    </message>
    <message>
        <source>Bring the cursor pair here</source>
        <translation>将光标对移到此处</translation>
    </message>
    <message>
        <source>Own time axis, paused</source>
        <translation>独立时间轴，已暂停</translation>
    </message>
    <message>
        <source>Own time axis, following, %1 s</source>
        <translation>独立时间轴，跟随，%1 s</translation>
    </message>
    <message>
        <source>Time axis of %1</source>
        <translation>%1 的时间轴</translation>
    </message>
    <message>
        <source>Own time axis</source>
        <translation>独立时间轴</translation>
    </message>
    <message>
        <source>One time axis for all plots</source>
        <translation>所有曲线图共用一个时间轴</translation>
    </message>
    <message>
        <source>Time axis of column %1</source>
        <translation>第 %1 列的时间轴</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Plot to the right</source>
        <translation>曲线图移到右边</translation>
    </message>
    <message>
        <source>Plot to the left</source>
        <translation>曲线图移到左边</translation>
    </message>
    <message>
        <source>Remove the plot</source>
        <translation>移除该曲线图</translation>
    </message>
    <message>
        <source>Marker with a note</source>
        <translation>带备注的标记</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>下一个标记</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>上一个标记</translation>
    </message>
    <message>
        <source>Remove the marker</source>
        <translation>移除标记</translation>
    </message>
    <message>
        <source>List of markers</source>
        <translation>标记列表</translation>
    </message>
    <message>
        <source>Zoom the values in</source>
        <translation>放大数值</translation>
    </message>
    <message>
        <source>Zoom the values out</source>
        <translation>缩小数值</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>适应数值</translation>
    </message>
    <message>
        <source>Taller plot</source>
        <translation>曲线图加高</translation>
    </message>
    <message>
        <source>Shorter plot</source>
        <translation>曲线图变矮</translation>
    </message>
    <message>
        <source>Wider column</source>
        <translation>列加宽</translation>
    </message>
    <message>
        <source>Narrower column</source>
        <translation>列变窄</translation>
    </message>
    <message>
        <source>Equal sizes</source>
        <translation>大小相等</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LookMenu</name>
    <message>
        <source>Blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>绿色</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>粉色</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>紫色</translation>
    </message>
    <message>
        <source>Ochre</source>
        <translation>赭色</translation>
    </message>
    <message>
        <source>Light blue</source>
        <translation>浅蓝色</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>灰色</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>实线</translation>
    </message>
    <message>
        <source>Dashed</source>
        <translation>虚线</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>点线</translation>
    </message>
    <message>
        <source>Dash-dot</source>
        <translation>点划线</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>%1 的颜色</translation>
    </message>
    <message>
        <source>Automatic colour and line</source>
        <translation>自动颜色和线型</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线型</translation>
    </message>
    <message>
        <source>Line of %1</source>
        <translation>%1 的线型</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogTableModel</name>
    <message>
        <source>Device time, as in its recordings</source>
        <translation>设备时间，与其记录一致</translation>
    </message>
    <message>
        <source>Local time of this computer</source>
        <translation>本计算机的本地时间</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>详细</translation>
    </message>
    <message>
        <source>note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1（%2 次）</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>时钟</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogView</name>
    <message>
        <source>Delete all messages</source>
        <translation>删除所有消息</translation>
    </message>
    <message>
        <source>Lowest level of messages shown</source>
        <translation>显示的最低消息级别</translation>
    </message>
    <message>
        <source>Info and above</source>
        <translation>信息及以上</translation>
    </message>
    <message>
        <source>Show only messages with this text</source>
        <translation>仅显示包含此文字的消息</translation>
    </message>
    <message>
        <source>Filter messages</source>
        <translation>筛选消息</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>警告和错误</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Level of messages</source>
        <translation>消息级别</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the selected messages, or all that are shown (%1)</source>
        <translation>复制所选消息，或全部显示的消息 (%1)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::MarkerBar</name>
    <message>
        <source>All markers by time (Ctrl+J); J selects the next one</source>
        <translation>按时间列出全部标记（Ctrl+J）；J 选择下一个</translation>
    </message>
    <message>
        <source>Deselect the marker</source>
        <translation>取消选择标记</translation>
    </message>
    <message>
        <source>Text of the marker; Enter saves it, Esc cancels</source>
        <translation>标记文字；回车键保存，Esc 取消</translation>
    </message>
    <message>
        <source>Note of the selected marker</source>
        <translation>所选标记的备注</translation>
    </message>
    <message>
        <source>Time of the selected marker</source>
        <translation>所选标记的时间</translation>
    </message>
    <message>
        <source>List of markers</source>
        <translation>标记列表</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Close the marker&apos;s row</source>
        <translation>关闭标记行</translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n 个标记</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>halbench::widgets::MessageBar</name>
    <message>
        <source>Dismiss this message (Delete)</source>
        <translation>关闭此消息 (Delete)</translation>
    </message>
    <message>
        <source>Dismiss message</source>
        <translation>关闭消息</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::NumberLabel</name>
    <message>
        <source>No new value from the device; last value shown</source>
        <translation>设备没有新值；显示最后的值</translation>
    </message>
    <message>
        <source>%1, old</source>
        <translation>%1，旧值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::NumberWords</name>
    <message>
        <source>&apos;%1&apos; is ambiguous. Use &apos;%2&apos; before the decimals and no thousands separators.</source>
        <translation>“%1”有歧义。小数点请用“%2”，不要用千位分隔符。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not allowed in a number. Use digits, a sign, &apos;%2&apos; before the decimals and e for a power of ten.</source>
        <translation>数字中不允许“%1”。请使用数字、正负号、小数点“%2”和表示十的幂的 e。</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>这不是数字。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::OptionalNumberEdit</name>
    <message>
        <source>At least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>More than %1</source>
        <translation>大于 %1</translation>
    </message>
    <message>
        <source>At most %1</source>
        <translation>至多 %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ParameterTable</name>
    <message>
        <source>Angle unit for display and input</source>
        <translation>显示和输入的角度单位</translation>
    </message>
    <message>
        <source>Show only values edited here or changed on the device</source>
        <translation>仅显示在此编辑或在设备上更改的值</translation>
    </message>
    <message>
        <source>Set every value to its default; nothing is written yet</source>
        <translation>将每个值设为默认值；尚未写入</translation>
    </message>
    <message>
        <source>Discard the edits and show the device values</source>
        <translation>放弃编辑并显示设备值</translation>
    </message>
    <message>
        <source>Select a parameter to see its description.</source>
        <translation>选择一个参数以查看其说明。</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>changes together with the other gains in one control cycle</source>
        <translation>与其他增益在同一控制周期内一起改变</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>使用 %1</translation>
    </message>
    <message>
        <source>%1 to %2 %3, default %4</source>
        <translation>%1 至 %2 %3，默认 %4</translation>
    </message>
    <message>
        <source>Write changed (%1)</source>
        <translation>写入更改 (%1)</translation>
    </message>
    <message>
        <source>Write changed</source>
        <translation>写入更改</translation>
    </message>
    <message>
        <source>Write the changed values to the device and read them back</source>
        <translation>将更改的值写入设备并回读</translation>
    </message>
    <message>
        <source>Connect a device to write to it</source>
        <translation>请连接设备后再写入</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Read all values from the device</source>
        <translation>从设备读取所有值</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>撤销上一次编辑</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Redo the edit</source>
        <translation>重做编辑</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>搜索参数</translation>
    </message>
    <message>
        <source>Search name, unit or help</source>
        <translation>搜索名称、单位或说明</translation>
    </message>
    <message>
        <source>Changed only</source>
        <translation>仅已更改</translation>
    </message>
    <message>
        <source>Angle unit</source>
        <translation>角度单位</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>F2 or typing edits the value</source>
        <translation>按 F2 或直接输入以编辑数值</translation>
    </message>
    <message>
        <source>Help on the parameter</source>
        <translation>参数说明</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ParameterTableModel</name>
    <message>
        <source>%1 must be a whole number, not %2.</source>
        <translation>%1 必须为整数，而不是 %2。</translation>
    </message>
    <message>
        <source>%1 is read-only.</source>
        <translation>%1 只读。</translation>
    </message>
    <message>
        <source>Allowed: %1 to %2.</source>
        <translation>允许 %1 至 %2。</translation>
    </message>
    <message>
        <source>Read-only value</source>
        <translation>只读值</translation>
    </message>
    <message>
        <source>Edited, not written yet; device value: %1</source>
        <translation>已编辑，尚未写入；设备值：%1</translation>
    </message>
    <message>
        <source>Device disconnected; last reported value</source>
        <translation>设备已断开；最后报告的值</translation>
    </message>
    <message>
        <source>Changed outside this window: %1 before, %2 now</source>
        <translation>在此窗口之外被更改：原为 %1，现为 %2</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>编辑值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>edit of %1</source>
        <translation>编辑 %1</translation>
    </message>
    <message>
        <source>%1: “%2” is not a number.</source>
        <translation>%1：“%2”不是数字。</translation>
    </message>
    <message>
        <source>%1: %2 is outside its limits.</source>
        <translation>%1：%2 超出限值。</translation>
    </message>
    <message>
        <source>revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>默认值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ProgressRow</name>
    <message>
        <source>Cancel and restore the previous state</source>
        <translation>取消并恢复之前的状态</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>正在取消…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>剩余 %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::QuantityEdit</name>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 至 %2 %3</translation>
    </message>
    <message>
        <source>Allowed: %1 (arrow keys: one step, Page Up and Page Down: ten)</source>
        <translation>允许：%1（方向键：一步，Page Up 和 Page Down：十步）</translation>
    </message>
    <message>
        <source>Allowed: %1.</source>
        <translation>允许：%1。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::RotorView</name>
    <message>
        <source>angle unknown</source>
        <translation>角度未知</translation>
    </message>
    <message>
        <source>as measured by the Hall sensors</source>
        <translation>霍尔传感器测得</translation>
    </message>
    <message numerus="yes">
        <source>%n separate magnets</source>
        <translation>
            <numerusform>%n 个独立磁体</numerusform>
        </translation>
    </message>
    <message>
        <source>ideal cylinder</source>
        <translation>理想圆筒</translation>
    </message>
    <message>
        <source>Cross-section of the rotor</source>
        <translation>转子横截面</translation>
    </message>
    <message>
        <source>rotor at %1 degrees</source>
        <translation>转子位于 %1 度</translation>
    </message>
    <message>
        <source>%1 (old); field: %2</source>
        <translation>%1（旧值）；磁场：%2</translation>
    </message>
    <message>
        <source>%1; field: %2</source>
        <translation>%1；磁场：%2</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>旧值</translation>
    </message>
    <message>
        <source>Angle ψ %1</source>
        <translation>角度 ψ %1</translation>
    </message>
    <message>
        <source>Coil A
%1
Coil B
%2</source>
        <translation>线圈 A
%1
线圈 B
%2</translation>
    </message>
    <message>
        <source>Hall A
%1
Hall B
%2</source>
        <translation>霍尔 A
%1
霍尔 B
%2</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ShareSplitter</name>
    <message>
        <source>Drag to change the sizes; double-click for equal sizes</source>
        <translation>拖动调整大小；双击使大小相等</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SpectrogramView</name>
    <message>
        <source>No data to show</source>
        <translation>无可显示的数据</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>频率 [Hz]</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Spectrogram</source>
        <translation>频谱图</translation>
    </message>
    <message>
        <source>highest %1</source>
        <translation>最大值 %1</translation>
    </message>
    <message>
        <source>%1 s, %2 Hz: %3 %4</source>
        <translation>%1 s，%2 Hz：%3 %4</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SphereView</name>
    <message>
        <source>orientation unknown</source>
        <translation>姿态未知</translation>
    </message>
    <message>
        <source>ambiguous: last orientation shown</source>
        <translation>有歧义：显示最后的姿态</translation>
    </message>
    <message>
        <source>doubtful: readings do not fit the model</source>
        <translation>存疑：读数与模型不符</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>旧值</translation>
    </message>
    <message>
        <source>Rotor, sensors and shaft from the side</source>
        <translation>转子、传感器和转轴的视图</translation>
    </message>
    <message>
        <source>shaft %1 degrees from Z; %2</source>
        <translation>转轴偏离 Z %1 度；%2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StaleWords</name>
    <message>
        <source>No new value since %1 s on the time axis</source>
        <translation>时间轴上自 %1 s 起没有新值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StatisticsTable</name>
    <message>
        <source>Slope from cursor A to B, per second</source>
        <translation>光标 A 到 B 的斜率（每秒）</translation>
    </message>
    <message>
        <source>Peak to peak: maximum minus minimum</source>
        <translation>峰峰值：最大值减最小值</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>Std dev</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值个数</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>间断</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Copy the table</source>
        <translation>复制表格</translation>
    </message>
    <message>
        <source>Pk-pk</source>
        <translation>峰峰值</translation>
    </message>
    <message>
        <source>Slope/s</source>
        <translation>斜率/s</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StatusStrip</name>
    <message>
        <source>Armed: %1</source>
        <translation>已使能：%1</translation>
    </message>
    <message>
        <source>Simulated device inside the program; no real motion</source>
        <translation>程序内的仿真设备；没有真实运动</translation>
    </message>
    <message>
        <source>%1, recording, %2</source>
        <translation>%1，记录，%2</translation>
    </message>
    <message>
        <source>Recorded samples; no device is connected</source>
        <translation>已录制的采样；未连接任何设备</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>已打开</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Running %1</source>
        <translation>%1 运行中</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Stopped (%1)</source>
        <translation>已停止（%1）</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Fault (%1)</source>
        <translation>故障（%1）</translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>State of the device</source>
        <translation>设备状态</translation>
    </message>
    <message>
        <source>%1, simulated, %2</source>
        <translation>%1，仿真，%2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StepList</name>
    <message>
        <source>current</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>done with a warning</source>
        <translation>完成，有警告</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1：%2。%3</translation>
    </message>
    <message>
        <source>Step %1 of %2, %3, %4</source>
        <translation>步骤 %1/%2，%3，%4</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StopButton</name>
    <message>
        <source>%1 STOP and Esc still work. To continue: Release, next to the state.</source>
        <translation>%1 “停止”和 Esc 仍有效。继续：状态旁边的“解除”。</translation>
    </message>
    <message>
        <source>Stopped; press again to repeat the stop</source>
        <translation>已停止；再按一次重复停止</translation>
    </message>
    <message>
        <source>Software stop: current off, latched until released (Esc)</source>
        <translation>软件停止：切断电流，锁存至解除 (Esc)</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Stopped: %1.</source>
        <translation>已停止：%1。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::TimeAxisBar</name>
    <message>
        <source>time relative to the event [s]</source>
        <translation>相对事件的时间 [s]</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::UnitMenu</name>
    <message>
        <source>Default of the preferences (%1)</source>
        <translation>首选项默认值 (%1)</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>%1 的单位</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::VerdictView</name>
    <message>
        <source>Findings</source>
        <translation>诊断</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::WindowTerms</name>
    <message>
        <source>enter the required phase margin</source>
        <translation>请输入所需的相位裕度</translation>
    </message>
    <message>
        <source>enter the required bandwidth</source>
        <translation>请输入所需的带宽</translation>
    </message>
    <message>
        <source>steady speeds alone do not determine the inertia: identify again with run-ups and coast-downs, or enter the given inertia J</source>
        <translation>仅凭稳态转速不能确定转动惯量：请加入升速和自由减速后重新辨识，或输入给定的转动惯量 J</translation>
    </message>
    <message>
        <source>identify the bare motor again with empty constants</source>
        <translation>将各常数留空，重新辨识裸电机</translation>
    </message>
    <message>
        <source>choose Identify again and enter the given inertia J or the given torque constant φ</source>
        <translation>选择“重新辨识”，并输入给定的转动惯量 J 或转矩常数 φ</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::PlatenDrawing</name>
    <message>
        <source>H%1</source>
        <translation>H%1</translation>
    </message>
    <message>
        <source>error ×1000</source>
        <translation>误差 ×1000</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>超出</translation>
    </message>
    <message>
        <source>no position is controlled</source>
        <translation>未进行位置控制</translation>
    </message>
    <message>
        <source>Field at a chip</source>
        <translation>芯片处的磁场</translation>
    </message>
    <message>
        <source>Residual ×%1</source>
        <translation>残差 ×%1</translation>
    </message>
    <message>
        <source>Force of a pair</source>
        <translation>一对线圈的力</translation>
    </message>
    <message>
        <source>Sum of the forces</source>
        <translation>合力</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>True place</source>
        <translation>真实位置</translation>
    </message>
    <message>
        <source>Bz −%1 … %1 T at z = %2 mm</source>
        <translation>Bz −%1 … %1 T，z = %2 mm</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::PlatenTable</name>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>±%1 A</source>
        <translation>±%1 A</translation>
    </message>
    <message>
        <source>to %1 °C</source>
        <translation>至 %1 °C</translation>
    </message>
    <message>
        <source>Coil</source>
        <translation>线圈</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Chip %1</source>
        <translation>芯片 %1</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>Chi-square</source>
        <translation>卡方</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>转矩</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>升力</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>受限</translation>
    </message>
    <message>
        <source>Reach left</source>
        <translation>剩余行程</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::PlatenView</name>
    <message>
        <source>Sho&amp;w all</source>
        <translation>显示全部(&amp;W)</translation>
    </message>
    <message>
        <source>Show the whole magnet matrix (Alt+W, Home)</source>
        <translation>显示整个磁阵列 (Alt+W, Home)</translation>
    </message>
    <message>
        <source>F&amp;ollow</source>
        <translation>跟随(&amp;O)</translation>
    </message>
    <message>
        <source>Keep the platen in the middle of the map (Alt+O)</source>
        <translation>使动子保持在图的中央 (Alt+O)</translation>
    </message>
    <message>
        <source>&amp;Clear path</source>
        <translation>清除轨迹(&amp;C)</translation>
    </message>
    <message>
        <source>Forget the way that the platen went (Alt+C)</source>
        <translation>清除动子走过的轨迹 (Alt+C)</translation>
    </message>
    <message>
        <source>pose not known</source>
        <translation>位姿未知</translation>
    </message>
    <message>
        <source>Pitch cell %1, %2</source>
        <translation>节距单元 %1, %2</translation>
    </message>
    <message>
        <source>homed</source>
        <translation>已回零</translation>
    </message>
    <message>
        <source>not homed</source>
        <translation>未回零</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>旧值</translation>
    </message>
    <message>
        <source>Platen over the magnet matrix</source>
        <translation>磁阵列上方的动子</translation>
    </message>
    <message>
        <source>platen at x %1 mm, y %2 mm, turned by %3 mrad</source>
        <translation>动子位于 x %1 mm、y %2 mm，转角 %3 mrad</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::RotorPicture</name>
    <message>
        <source>&amp;Ideal</source>
        <translation>理想(&amp;I)</translation>
    </message>
    <message>
        <source>Field of an ideal Halbach cylinder (Alt+I)</source>
        <translation>理想海尔贝克圆筒的磁场 (Alt+I)</translation>
    </message>
    <message>
        <source>Se&amp;gmented</source>
        <translation>分段(&amp;G)</translation>
    </message>
    <message>
        <source>Field of the individual magnets (Alt+G)</source>
        <translation>各独立磁体的磁场 (Alt+G)</translation>
    </message>
    <message>
        <source>Meas&amp;ured</source>
        <translation>实测(&amp;U)</translation>
    </message>
    <message>
        <source>Direction and magnitude measured by the Hall sensors (Alt+U)</source>
        <translation>霍尔传感器测得的方向和大小 (Alt+U)</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SpherePicture</name>
    <message>
        <source>&amp;Clear path</source>
        <translation>清除轨迹(&amp;C)</translation>
    </message>
    <message>
        <source>Clear the path of the shaft (Alt+C)</source>
        <translation>清除转轴轨迹 (Alt+C)</translation>
    </message>
    <message>
        <source>α %1°, β %2°, γ %3° (γ about Z first, then β about Y, then α about X)</source>
        <translation>α %1°，β %2°，γ %3°（先绕 Z 转 γ，再绕 Y 转 β，最后绕 X 转 α）</translation>
    </message>
    <message>
        <source>q %1 mT, chi-square %2, 95 % cone ±%3°</source>
        <translation>q %1 mT，卡方 %2，95 % 锥 ±%3°</translation>
    </message>
    <message>
        <source>simulated truth: α %1°, β %2°, γ %3°; error %4°</source>
        <translation>仿真真值：α %1°，β %2°，γ %3°；误差 %4°</translation>
    </message>
    <message>
        <source>changes to another orientation with the same field: %1</source>
        <translation>切换到磁场相同的另一姿态的次数：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::FileDrop</name>
    <message>
        <source>Drop a recording or table (.csv, .txt, .tsv, .mf4) or a project (.toml).</source>
        <translation>请拖放记录或表格（.csv、.txt、.tsv、.mf4）或项目（.toml）。</translation>
    </message>
    <message>
        <source>%1 cannot be opened by dropping it</source>
        <translation>%1 无法通过拖放打开</translation>
    </message>
    <message>
        <source>Drop one recording or one project.</source>
        <translation>请拖放一个记录或一个项目。</translation>
    </message>
    <message>
        <source>One file at a time</source>
        <translation>一次只能打开一个文件</translation>
    </message>
</context>
<context>
    <name>halbench::app::ShortcutList</name>
    <message>
        <source>Panel</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>功能</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Close the list (Esc, which also stops)</source>
        <translation>关闭列表（Esc，同时停止）</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Shows rows that contain all words</source>
        <translation>显示包含所有词的行</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>搜索快捷键</translation>
    </message>
    <message>
        <source>Search keys, functions, panels</source>
        <translation>搜索按键、功能、面板</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
</context>
<context>
    <name>halbench::app::AboutDialog</name>
    <message>
        <source>Copy the versions for a fault report</source>
        <translation>复制版本信息用于故障报告</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>复制(&amp;P)</translation>
    </message>
    <message>
        <source>Close (Esc, which also stops)</source>
        <translation>关闭（Esc，同时停止）</translation>
    </message>
    <message>
        <source>Free software, GNU General Public License, version 3. No warranty.</source>
        <translation>自由软件，GNU 通用公共许可证第 3 版。不提供担保。</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Workstation for precision Lorentz-force actuators: watch, calibrate, identify, tune, verify and record.</source>
        <translation>精密洛伦兹力执行器工作站：监视、标定、辨识、整定、验证和记录。</translation>
    </message>
    <message>
        <source>About Halbench</source>
        <translation>关于 Halbench</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesFrequencyFigures</name>
    <message>
        <source>coherence</source>
        <translation>相干性</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Open loop of each axis, the others closed</source>
        <translation>各轴的开环（其他轴闭环）</translation>
    </message>
    <message>
        <source>Response to the effort of another axis, relative to its own</source>
        <translation>对其他轴作用量的响应，相对于对自身作用量的响应</translation>
    </message>
    <message>
        <source>relative response</source>
        <translation>相对响应</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 ← %2</translation>
    </message>
    <message>
        <source>Largest singular values of all loops together</source>
        <translation>所有回路合在一起的最大奇异值</translation>
    </message>
    <message>
        <source>singular value</source>
        <translation>奇异值</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesFrequencyPanel</name>
    <message>
        <source>Save response</source>
        <translation>保存响应</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>频率响应 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Excite</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Measures the loops of all axes together, with the gains of the device: margins of each axis with 95 % intervals, and the coupling between them.</source>
        <translation>用设备的增益一起测量所有轴的回路：各轴的裕度及 95 % 区间，以及各轴之间的耦合。</translation>
    </message>
    <message>
        <source>The actuator is excited around its position. STOP (Esc) and Cancel end the run; mode, windows and generator are restored, the gains are not changed.</source>
        <translation>执行器在其位置附近受到激励。停止 (Esc) 和取消可结束运行；模式、窗口和发生器会恢复，增益不变。</translation>
    </message>
    <message>
        <source>Computing the response</source>
        <translation>正在计算频率响应</translation>
    </message>
    <message>
        <source>Start measurement</source>
        <translation>开始测量</translation>
    </message>
    <message>
        <source>The actuator moves (Ctrl+Return); Esc stops it</source>
        <translation>执行器将运动 (Ctrl+Return)；Esc 停止</translation>
    </message>
    <message>
        <source>Save response…</source>
        <translation>保存响应…</translation>
    </message>
    <message>
        <source>Save the matrix of responses as a file</source>
        <translation>将响应矩阵保存为文件</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Save the points with error and coherence as CSV</source>
        <translation>将各点连同误差和相干性保存为 CSV</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>返回设置；此结果保留到下一次运行</translation>
    </message>
    <message>
        <source>Lowest frequency [Hz]</source>
        <translation>最低频率 [Hz]</translation>
    </message>
    <message>
        <source>Highest frequency [Hz]</source>
        <translation>最高频率 [Hz]</translation>
    </message>
    <message>
        <source>Effort [%]</source>
        <translation>作用量 [%]</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>One period of the excitation lasts at least two of this frequency</source>
        <translation>激励的一个周期至少持续该频率的两个周期</translation>
    </message>
    <message>
        <source>At most 45 % of the sampling rate of the loops</source>
        <translation>不超过回路采样率的 45 %</translation>
    </message>
    <message>
        <source>Amplitude of a sine of the same rms, of the largest effort of each axis; reduced where an axis would swing too far</source>
        <translation>相同有效值的正弦的幅值，占各轴最大作用量的百分比；某轴摆幅过大时自动减小</translation>
    </message>
    <message>
        <source>Periods of each experiment that are averaged; the intervals shrink with the square root</source>
        <translation>每次实验取平均的周期数；区间按平方根缩小</translation>
    </message>
    <message>
        <source>Excited axes</source>
        <translation>受激励的轴</translation>
    </message>
    <message>
        <source>All at once shows the coupling; the loops of the others stay closed</source>
        <translation>全部同时激励可显示耦合；其他轴的回路保持闭环</translation>
    </message>
    <message>
        <source>Measured margins</source>
        <translation>测得的裕度</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>回路</translation>
    </message>
    <message>
        <source>Open loop of each axis while the others are closed, and coherence</source>
        <translation>各轴的开环（其他轴闭环）和相干性</translation>
    </message>
    <message>
        <source>Coupling</source>
        <translation>耦合</translation>
    </message>
    <message>
        <source>Response of each axis to the effort of another, relative to its own</source>
        <translation>各轴对其他轴作用量的响应，相对于对自身作用量的响应</translation>
    </message>
    <message>
        <source>All together</source>
        <translation>整体</translation>
    </message>
    <message>
        <source>Largest singular values of S and T over frequency</source>
        <translation>S 和 T 的最大奇异值随频率的变化</translation>
    </message>
    <message>
        <source>Pictures of the frequency response</source>
        <translation>频率响应的图形</translation>
    </message>
    <message>
        <source>all at once</source>
        <translation>全部同时</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Enter a number</source>
        <translation>请输入数字</translation>
    </message>
    <message>
        <source>Connect a device with several axes.</source>
        <translation>请连接多轴设备。</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Measurement cancelled. Nothing was changed.</source>
        <translation>测量已取消。未更改任何内容。</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>用于整定</translation>
    </message>
    <message>
        <source>Show the points in the open loop of each axis in Tune</source>
        <translation>在整定中将实测点显示于各轴的开环图</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesFrequencyWords</name>
    <message>
        <source>not given: largest at the edge of the band</source>
        <translation>未给出：最大值在频带边缘</translation>
    </message>
    <message>
        <source>not given: no frequency with every axis coherent</source>
        <translation>未给出：没有所有轴都相干的频率</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>at %1 Hz</source>
        <translation>在 %1 Hz 处</translation>
    </message>
    <message>
        <source>Strongest coupling: full effort of %1 moves %2 by %3 % of what its own full effort does, at %4 Hz.</source>
        <translation>最强耦合：%1 的满作用量使 %2 产生的运动为其自身满作用量所致运动的 %3 %，在 %4 Hz 处。</translation>
    </message>
    <message>
        <source>No coupling between the axes was seen above the scatter.</source>
        <translation>未见超出散布的轴间耦合。</translation>
    </message>
    <message>
        <source>The loops hold the position; %1 are excited from %2 to %3 Hz with %4 % of their largest effort, for %5 minutes of device time.</source>
        <translation>回路保持位置；%1 在 %2 至 %3 Hz 内以其最大作用量的 %4 % 受激励，设备时间 %5 分钟。</translation>
    </message>
    <message>
        <source>The loops are measured with the gains of the device, which are not changed. Everything else is restored.</source>
        <translation>回路用设备的增益测量，增益不变。其他设置均会恢复。</translation>
    </message>
    <message>
        <source>%1: phase margin</source>
        <translation>%1：相位裕度</translation>
    </message>
    <message>
        <source>%1: gain margin</source>
        <translation>%1：幅值裕度</translation>
    </message>
    <message>
        <source>peak of the largest singular value of S</source>
        <translation>S 的最大奇异值的峰值</translation>
    </message>
    <message>
        <source>peak of the largest singular value of T</source>
        <translation>T 的最大奇异值的峰值</translation>
    </message>
    <message>
        <source>%1: %2 of %3 frequencies have a coherence of at least %4.</source>
        <translation>%1：%3 个频率中有 %2 个的相干性不低于 %4。</translation>
    </message>
    <message>
        <source>S and T: positions in units of the test steps of the axes.</source>
        <translation>S 和 T：位置以各轴的测试阶跃为单位。</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesIdentifyPanel</name>
    <message>
        <source>Save as model</source>
        <translation>另存为模型</translation>
    </message>
    <message>
        <source>Model (*.json)</source>
        <translation>模型 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Excite</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Finds damping, gain and friction of every axis and the constants of the actuator with their 95 % intervals, by moving it to and fro while all axes are excited.</source>
        <translation>通过往复运动并同时激励所有轴，求出各轴的阻尼、增益和摩擦以及执行器的常数及其 95 % 区间。</translation>
    </message>
    <message>
        <source>The actuator moves. STOP (Esc) and Cancel end it; gains, limits, mode, windows and generator are restored.</source>
        <translation>执行器正在运动。停止 (Esc) 和取消可结束运动；增益、限值、模式、窗口和发生器会恢复。</translation>
    </message>
    <message>
        <source>Computing the result</source>
        <translation>正在计算结果</translation>
    </message>
    <message>
        <source>Start identification</source>
        <translation>开始辨识</translation>
    </message>
    <message>
        <source>The actuator moves (Ctrl+Return); Esc stops it</source>
        <translation>执行器将运动 (Ctrl+Return)；Esc 停止</translation>
    </message>
    <message>
        <source>Tune with this model</source>
        <translation>用此模型整定</translation>
    </message>
    <message>
        <source>Go on to the gains for these axes</source>
        <translation>继续整定这些轴的增益</translation>
    </message>
    <message>
        <source>Save as model…</source>
        <translation>另存为模型…</translation>
    </message>
    <message>
        <source>Save a file for the commands tune and analyse</source>
        <translation>保存供 tune 和 analyse 命令使用的文件</translation>
    </message>
    <message>
        <source>Identify again</source>
        <translation>重新辨识</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next run</source>
        <translation>返回设置；此结果保留到下一次运行</translation>
    </message>
    <message>
        <source>Identified values</source>
        <translation>辨识值</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Axes of the model</source>
        <translation>模型的轴</translation>
    </message>
    <message>
        <source>Axes of the model; all axes move during the run</source>
        <translation>模型的轴；运行期间所有轴都会运动</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1 in %2, if known. Without a known constant only ratios are identified, which is enough for tuning</source>
        <translation>%1，单位 %2，已知时填写。没有已知常数时只能辨识比值，这对整定已足够</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>请更正或留空</translation>
    </message>
    <message>
        <source>Connect a device with several axes.</source>
        <translation>请连接多轴设备。</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Identifying</source>
        <translation>正在辨识</translation>
    </message>
    <message>
        <source>Identification cancelled. Nothing was changed.</source>
        <translation>辨识已取消。未更改任何内容。</translation>
    </message>
    <message>
        <source>Tuning uses damping rate, acceleration per effort and friction of each axis.</source>
        <translation>整定使用各轴的阻尼率、单位作用量的加速度和摩擦。</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxesIdentifyWords</name>
    <message>
        <source>%1: damping rate</source>
        <translation>%1：阻尼率</translation>
    </message>
    <message>
        <source>%1: acceleration per effort</source>
        <translation>%1：单位作用量的加速度</translation>
    </message>
    <message>
        <source>%1: friction, as effort</source>
        <translation>%1：摩擦（以作用量计）</translation>
    </message>
    <message>
        <source>Motion of %1 for %2 minutes of device time, up to %3 A in a coil, maximum coil temperature %4 °C.</source>
        <translation>%1 运动，设备时间 %2 分钟，线圈电流最大 %3 A，线圈温度最高 %4 °C。</translation>
    </message>
    <message>
        <source>The board monitors its windows. Gains, limits and references are restored in every case.</source>
        <translation>控制板监视其窗口。增益、限值和参考值在任何情况下都会恢复。</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisFigures</name>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>effort</source>
        <translation>作用量</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Predicted step of axis %1</source>
        <translation>轴 %1 的预测阶跃</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>other axes</source>
        <translation>其他轴</translation>
    </message>
    <message>
        <source>Verification step of axis %1</source>
        <translation>轴 %1 的验证阶跃</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisGainEditor</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Enter a number</source>
        <translation>请输入数字</translation>
    </message>
    <message>
        <source>Proportional gain</source>
        <translation>比例增益</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>积分增益</translation>
    </message>
    <message>
        <source>Derivative gain</source>
        <translation>微分增益</translation>
    </message>
    <message>
        <source>Set-point weight b of the proportional part</source>
        <translation>比例部分的设定值权重 b</translation>
    </message>
    <message>
        <source>Set-point weight c of the derivative part</source>
        <translation>微分部分的设定值权重 c</translation>
    </message>
    <message>
        <source>Time constant of the derivative&apos;s filter</source>
        <translation>微分滤波器的时间常数</translation>
    </message>
    <message>
        <source>Weight b</source>
        <translation>权重 b</translation>
    </message>
    <message>
        <source>Weight c</source>
        <translation>权重 c</translation>
    </message>
    <message>
        <source>Filter T_f</source>
        <translation>滤波 T_f</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisResponseButton</name>
    <message>
        <source>Measured response…</source>
        <translation>测得的响应…</translation>
    </message>
    <message>
        <source>Show a measured frequency response in the open loops</source>
        <translation>在开环图中显示测得的频率响应</translation>
    </message>
    <message>
        <source>Open a measured response</source>
        <translation>打开测得的响应</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>频率响应 (*.json)</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisTunePanel</name>
    <message>
        <source>Verification: %1</source>
        <translation>验证：%1</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Axis of the loop shown</source>
        <translation>所示回路的轴</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Design method for the gains of this axis</source>
        <translation>该轴增益的设计方法</translation>
    </message>
    <message>
        <source>Axes to apply</source>
        <translation>要应用的轴</translation>
    </message>
    <message>
        <source>Gains that Apply and verify writes, in one transaction</source>
        <translation>“应用并验证”以一次事务写入的增益</translation>
    </message>
    <message>
        <source>all axes</source>
        <translation>所有轴</translation>
    </message>
    <message>
        <source>this axis</source>
        <translation>此轴</translation>
    </message>
    <message>
        <source>Apply and verify</source>
        <translation>应用并验证</translation>
    </message>
    <message>
        <source>Write the gains in one transaction, then verify each axis with a step; Esc stops it</source>
        <translation>以一次事务写入增益，再用阶跃验证各轴；按 Esc 停止</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Write the gains from before the last apply</source>
        <translation>写回上次应用之前的增益</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>开环</translation>
    </message>
    <message>
        <source>Bode, Nyquist and Nichols plot, and sensitivity</source>
        <translation>Bode 图、Nyquist 图、Nichols 图和灵敏度</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>The test step with friction and effort limit</source>
        <translation>含摩擦和作用量限值的测试阶跃</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Measured step over its prediction, after Apply and verify</source>
        <translation>测得的阶跃与其预测叠加，在“应用并验证”之后</translation>
    </message>
    <message>
        <source>Predictions</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Writing the gains</source>
        <translation>正在写入增益</translation>
    </message>
    <message>
        <source>Cancelled. Previous gains restored.</source>
        <translation>已取消。已恢复之前的增益。</translation>
    </message>
    <message>
        <source>Applied, and every verification step went as predicted.</source>
        <translation>已应用，各验证阶跃均与预测一致。</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>The gains from before run again: a verification step did not go as predicted.</source>
        <translation>已恢复之前的增益：有一个验证阶跃与预测不符。</translation>
    </message>
    <message>
        <source>Previous gains restored.</source>
        <translation>已恢复之前的增益。</translation>
    </message>
    <message>
        <source>Remove the response</source>
        <translation>移除频率响应</translation>
    </message>
    <message>
        <source>Show only predictions in the open loop of this axis</source>
        <translation>该轴的开环图中只显示预测</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>Measured response shown in the open loop of each axis, the others closed.</source>
        <translation>测得的响应已显示在各轴的开环图中，其他轴闭环。</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies are coherent; the others are hollow.</source>
        <translation>%2 个频率中有 %1 个相干；其余为空心点。</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisTargets</name>
    <message>
        <source>damping ratio</source>
        <translation>阻尼比</translation>
    </message>
    <message>
        <source>frequency [rad/s]</source>
        <translation>频率 [rad/s]</translation>
    </message>
    <message>
        <source>bandwidth [Hz]</source>
        <translation>带宽 [Hz]</translation>
    </message>
    <message>
        <source>phase margin [°]</source>
        <translation>相位裕度 [°]</translation>
    </message>
    <message>
        <source>chosen by the method</source>
        <translation>由方法选定</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisVerdict</name>
    <message>
        <source>Computing the loops</source>
        <translation>正在计算回路</translation>
    </message>
    <message>
        <source>All axes: %1</source>
        <translation>所有轴：%1</translation>
    </message>
    <message>
        <source>Axis %1: %2</source>
        <translation>轴 %1：%2</translation>
    </message>
</context>
<context>
    <name>halbench::app::AxisGainFiles</name>
    <message>
        <source>Save gains…</source>
        <translation>保存增益…</translation>
    </message>
    <message>
        <source>Save the gains of all axes to a file</source>
        <translation>将所有轴的增益保存到文件</translation>
    </message>
    <message>
        <source>Open gains…</source>
        <translation>打开增益…</translation>
    </message>
    <message>
        <source>Propose the gains of a file; they are assessed first</source>
        <translation>将文件中的增益作为建议值；先进行评估</translation>
    </message>
    <message>
        <source>Open gains</source>
        <translation>打开增益</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>增益 (*.json)</translation>
    </message>
    <message>
        <source>Gains of %1.</source>
        <translation>来自 %1 的增益。</translation>
    </message>
    <message>
        <source>It has none for %1, which keep their own.</source>
        <translation>文件中没有 %1 的增益，保留其原有增益。</translation>
    </message>
    <message>
        <source>Save gains</source>
        <translation>保存增益</translation>
    </message>
</context>
<context>
    <name>halbench::app::TurnText</name>
    <message>
        <source>The rotor will turn in reverse at %1 rad/s, about %2 turns, for %3 minutes of device time.</source>
        <translation>转子将以 %1 rad/s 反转，约 %2 转，设备时间 %3 分钟。</translation>
    </message>
    <message>
        <source>The rotor will turn forward at %1 rad/s, about %2 turns, for %3 minutes of device time.</source>
        <translation>转子将以 %1 rad/s 正转，约 %2 转，设备时间 %3 分钟。</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>List All Tabs</source>
        <translation>列出所有标签页</translation>
    </message>
    <message>
        <source>Detach Group</source>
        <translation>分离标签组</translation>
    </message>
    <message>
        <source>Close Active Tab</source>
        <translation>关闭当前标签页</translation>
    </message>
    <message>
        <source>Close Group</source>
        <translation>关闭标签组</translation>
    </message>
    <message>
        <source>Close Tab</source>
        <translation>关闭标签页</translation>
    </message>
</context>
<context>
    <name>ads::CDockAreaTitleBar</name>
    <message>
        <source>List All Tabs</source>
        <translation>列出所有标签页</translation>
    </message>
    <message>
        <source>Detach Group</source>
        <translation>分离标签组</translation>
    </message>
    <message>
        <source>Close Active Tab</source>
        <translation>关闭当前标签页</translation>
    </message>
    <message>
        <source>Close Group</source>
        <translation>关闭标签组</translation>
    </message>
    <message>
        <source>Close Other Groups</source>
        <translation>关闭其他标签组</translation>
    </message>
</context>
<context>
    <name>ads::CDockWidgetTab</name>
    <message>
        <source>Detach</source>
        <translation>分离</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close Others</source>
        <translation>关闭其他</translation>
    </message>
    <message>
        <source>Close Tab</source>
        <translation>关闭标签页</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::CopyMenu</name>
    <message>
        <source>Copy cell</source>
        <translation>复制单元格</translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>复制所选行</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>复制表格</translation>
    </message>
</context>
<context>
    <name>halbench::app::EstimatorPanel</name>
    <message>
        <source>Tensor</source>
        <translation>张量</translation>
    </message>
    <message>
        <source>Projector</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Projector + Gauss-Newton step</source>
        <translation>投影 + 高斯-牛顿一步</translation>
    </message>
    <message>
        <source>Levenberg-Marquardt</source>
        <translation>莱文贝格-马夸特</translation>
    </message>
    <message>
        <source>Closed form, additive model</source>
        <translation>闭式解，叠加模型</translation>
    </message>
    <message>
        <source>Closed form + least squares</source>
        <translation>闭式解 + 最小二乘</translation>
    </message>
    <message>
        <source>Particle swarm, additive model</source>
        <translation>粒子群，叠加模型</translation>
    </message>
    <message>
        <source>Sensors of the comparison</source>
        <translation>用于比较的传感器</translation>
    </message>
    <message>
        <source>Readings from</source>
        <translation>读数来源</translation>
    </message>
    <message>
        <source>Model that makes the readings of the sensors</source>
        <translation>产生传感器读数的模型</translation>
    </message>
    <message>
        <source>Physical field</source>
        <translation>物理磁场</translation>
    </message>
    <message>
        <source>Additive model</source>
        <translation>叠加模型</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>Noise of each reading, rms; at first that of the board</source>
        <translation>每个读数的噪声（有效值）；起初为控制板的噪声</translation>
    </message>
    <message>
        <source>Failure above</source>
        <translation>失败阈值</translation>
    </message>
    <message>
        <source>A pose with a larger error has failed</source>
        <translation>误差更大的位姿视为失败</translation>
    </message>
    <message>
        <source>Harmonic passes</source>
        <translation>谐波校正次数</translation>
    </message>
    <message>
        <source>How often the board&apos;s harmonics are corrected; 0: never</source>
        <translation>控制板谐波的校正次数；0：不校正</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Equal seeds give equal poses and noise</source>
        <translation>相同种子给出相同位姿和噪声</translation>
    </message>
    <message>
        <source>Co&amp;mpare estimators</source>
        <translation>比较估计器(&amp;M)</translation>
    </message>
    <message>
        <source>Estimate all poses with each of them (Alt+M)</source>
        <translation>用每个估计器估计全部位姿 (Alt+M)</translation>
    </message>
    <message>
        <source>Comparing the estimators</source>
        <translation>正在比较估计器</translation>
    </message>
    <message>
        <source>Estimators compared</source>
        <translation>估计器比较</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>估计器</translation>
    </message>
    <message>
        <source>rms error [°]</source>
        <translation>误差有效值 [°]</translation>
    </message>
    <message>
        <source>Largest error [°]</source>
        <translation>最大误差 [°]</translation>
    </message>
    <message>
        <source>Shaft, rms [°]</source>
        <translation>转轴，有效值 [°]</translation>
    </message>
    <message>
        <source>Failures</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Time per pose [µs]</source>
        <translation>每位姿用时 [µs]</translation>
    </message>
    <message>
        <source>The comparison was cancelled.</source>
        <translation>比较已取消。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Poses on which the estimators are compared</source>
        <translation>用于比较估计器的位姿</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>随机</translation>
    </message>
    <message>
        <source>Trajectory 1: tilt at Φ = 0°</source>
        <translation>轨迹 1：在 Φ = 0° 倾斜</translation>
    </message>
    <message>
        <source>Trajectory 2: tilt at Φ = 90°</source>
        <translation>轨迹 2：在 Φ = 90° 倾斜</translation>
    </message>
    <message>
        <source>Trajectory 3: around at Θ = 45°</source>
        <translation>轨迹 3：在 Θ = 45° 绕行</translation>
    </message>
    <message>
        <source>Trajectory 4: spiral</source>
        <translation>轨迹 4：螺旋</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>位姿数</translation>
    </message>
    <message>
        <source>Spin γ</source>
        <translation>自转 γ</translation>
    </message>
    <message>
        <source>Rotation about the shaft along a trajectory</source>
        <translation>沿轨迹绕转轴的旋转</translation>
    </message>
    <message>
        <source>Noise that the recorded readings have; nothing is added</source>
        <translation>已记录读数具有的噪声；不再添加</translation>
    </message>
    <message>
        <source>Rows of the recording</source>
        <translation>记录的行</translation>
    </message>
    <message>
        <source>The time is that of one thread of this computer.</source>
        <translation>时间为本机单线程的用时。</translation>
    </message>
    <message>
        <source>Errors are measured to the nearest of the four orientations with the same field.</source>
        <translation>误差按四个同场姿态中最近的一个计算。</translation>
    </message>
    <message>
        <source>Compares orientation estimators on the same poses. Connect a device that measures the field of a rotor in space, or play a recording of one.</source>
        <translation>在相同位姿上比较姿态估计器。请连接测量空间转子磁场的设备，或播放其记录。</translation>
    </message>
    <message>
        <source>Sensors at %1 (%4), %2 mm from the centre; q %3 mT</source>
        <translation>传感器位于 %1（%4），距中心 %2 mm；q %3 mT</translation>
    </message>
    <message>
        <source>Rows of the last 10 seconds</source>
        <translation>最近 10 秒的行</translation>
    </message>
    <message>
        <source>Random poses in the workspace, or rows, chosen evenly</source>
        <translation>工作空间内的随机位姿，或均匀选取的行</translation>
    </message>
    <message>
        <source>The rows have no true angles (truth.alpha, truth.beta, truth.gamma): errors are differences from the projector with a Gauss-Newton step.</source>
        <translation>这些行没有真实角度（truth.alpha、truth.beta、truth.gamma）：误差为与投影 + 高斯-牛顿一步的差。</translation>
    </message>
</context>
<context>
    <name>halbench::app::CoveragePanel</name>
    <message>
        <source>Sensors of the map</source>
        <translation>用于覆盖图的传感器</translation>
    </message>
    <message>
        <source>Click or arrow keys read a pose; Home goes to the middle</source>
        <translation>单击或方向键读取位姿；Home 键回到中间</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Quantity that the colours show</source>
        <translation>颜色所表示的量</translation>
    </message>
    <message>
        <source>Least reading</source>
        <translation>最小读数</translation>
    </message>
    <message>
        <source>Predicted angle error</source>
        <translation>预测角度误差</translation>
    </message>
    <message>
        <source>Readings from</source>
        <translation>读数来源</translation>
    </message>
    <message>
        <source>Model that makes the readings of the sensors</source>
        <translation>产生传感器读数的模型</translation>
    </message>
    <message>
        <source>Physical field</source>
        <translation>物理磁场</translation>
    </message>
    <message>
        <source>Additive model</source>
        <translation>叠加模型</translation>
    </message>
    <message>
        <source>Held angle</source>
        <translation>固定角</translation>
    </message>
    <message>
        <source>Angle of the slider; the map is over the other two</source>
        <translation>滑块所调的角；图为另外两个角</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Least reading of R, Θ and Φ in a covered pose</source>
        <translation>已覆盖位姿中 R、Θ、Φ 的最小读数</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>Noise of each reading, rms, for the predicted error</source>
        <translation>每个读数的噪声（有效值），用于预测误差</translation>
    </message>
    <message>
        <source>Angle at which the map is cut</source>
        <translation>图的截取角度</translation>
    </message>
    <message>
        <source>Pose read from the map</source>
        <translation>从图读取的位姿</translation>
    </message>
    <message>
        <source>Coverage of all poses</source>
        <translation>全部位姿的覆盖</translation>
    </message>
    <message>
        <source>Go to &amp;counterexample</source>
        <translation>转到反例(&amp;C)</translation>
    </message>
    <message>
        <source>Show the slice of the uncovered pose (Alt+C)</source>
        <translation>显示未覆盖位姿所在的截面 (Alt+C)</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>保存图片(&amp;P)…</translation>
    </message>
    <message>
        <source>Save as SVG, PDF or PNG (Alt+P)</source>
        <translation>保存为 SVG、PDF 或 PNG (Alt+P)</translation>
    </message>
    <message>
        <source>Shows where field sensors about a rotor read enough. Connect a device with such sensors, or play a recording of one.</source>
        <translation>显示转子周围的磁场传感器在哪些位姿下读数足够。请连接带有此类传感器的设备，或播放其记录。</translation>
    </message>
    <message>
        <source>Slider for %1</source>
        <translation>%1 的滑块</translation>
    </message>
    <message>
        <source>Arrow keys: half a degree; Page Up and Down: five</source>
        <translation>方向键：0.5 度；Page Up/Down：5 度</translation>
    </message>
    <message>
        <source>%1 of %2 poses of this slice are not covered.</source>
        <translation>此截面的 %2 个位姿中有 %1 个未覆盖。</translation>
    </message>
    <message>
        <source>Proven: all poses of the workspace are covered.</source>
        <translation>已证明：工作空间的全部位姿均已覆盖。</translation>
    </message>
    <message>
        <source>Not covered: (%1, %2, %3)°, where %4 is at most %5 mT.</source>
        <translation>未覆盖：(%1, %2, %3)°，该处 %4 最多 %5 mT。</translation>
    </message>
    <message>
        <source>On trial, not on the board. %1</source>
        <translation>试用，未写入控制板。%1</translation>
    </message>
    <message>
        <source>Least reading %1 mT, conditioning %2, predicted error %3° rms</source>
        <translation>最小读数 %1 mT，条件数 %2，预测误差 %3°（均方根）</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Figures of the placement</source>
        <translation>布置的指标</translation>
    </message>
    <message>
        <source>&amp;Board&apos;s placement</source>
        <translation>控制板的布置(&amp;B)</translation>
    </message>
    <message>
        <source>Show the sensors of the board again (Alt+B)</source>
        <translation>重新显示控制板的传感器 (Alt+B)</translation>
    </message>
    <message>
        <source>&amp;Recommended</source>
        <translation>推荐布置(&amp;R)</translation>
    </message>
    <message>
        <source>Try the placement that is proven to cover all (Alt+R)</source>
        <translation>试用经证明完全覆盖的布置 (Alt+R)</translation>
    </message>
    <message>
        <source>Poses are (α, β, γ): %1.</source>
        <translation>位姿为 (α, β, γ)：%1。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::CoverageView</name>
    <message>
        <source>%1, not covered</source>
        <translation>%1，未覆盖</translation>
    </message>
    <message>
        <source>Map of the coverage over two angles</source>
        <translation>两个角上的覆盖图</translation>
    </message>
</context>
<context>
    <name>halbench::app::PlacementEditor</name>
    <message>
        <source>Drag a sensor, or 0, 1, 2 and arrow keys; Shift turns</source>
        <translation>拖动传感器，或按 0、1、2 和方向键；按住 Shift 旋转视图</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>Sensor that the angles and arrow keys move</source>
        <translation>由角度和方向键移动的传感器</translation>
    </message>
    <message>
        <source>Rotation from the X axis to the sensor&apos;s place</source>
        <translation>从 X 轴到传感器位置的旋转</translation>
    </message>
    <message>
        <source>Order of the rotations</source>
        <translation>旋转顺序</translation>
    </message>
</context>
<context>
    <name>halbench::app::SimulationOptionsDialog</name>
    <message>
        <source>Simulation options</source>
        <translation>仿真选项</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Filter by name or meaning</source>
        <translation>按名称或含义筛选</translation>
    </message>
    <message>
        <source>Write the options into the address</source>
        <translation>将选项写入地址</translation>
    </message>
    <message>
        <source>Standard values</source>
        <translation>标准值</translation>
    </message>
    <message>
        <source>Remove all options</source>
        <translation>移除所有选项</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>键</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>random</source>
        <translation>随机</translation>
    </message>
    <message>
        <source>Enter a value of the range, or leave the cell empty.</source>
        <translation>请输入范围内的值，或将单元格留空。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::HallTraceView</name>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
    <message>
        <source>Hall readings over a turn</source>
        <translation>一转内的霍尔读数</translation>
    </message>
    <message>
        <source>Hall B over Hall A, the newest reading at each angle</source>
        <translation>霍尔 B 对霍尔 A，每个角度的最新读数</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecentLists</name>
    <message>
        <source>moved or deleted</source>
        <translation>已移动或已删除</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>没有读取权限</translation>
    </message>
    <message>
        <source>Enter opens, Delete removes from the list</source>
        <translation>回车打开，Delete 从列表中移除</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>最近的项目</translation>
    </message>
    <message>
        <source>No recent projects. Ctrl+O opens one, Ctrl+S saves this one.</source>
        <translation>没有最近的项目。Ctrl+O 打开项目，Ctrl+S 保存当前项目。</translation>
    </message>
    <message>
        <source>Recent recordings</source>
        <translation>最近的记录</translation>
    </message>
    <message>
        <source>No recent recordings. Ctrl+R records a device.</source>
        <translation>没有最近的记录。Ctrl+R 记录设备数据。</translation>
    </message>
</context>
<context>
    <name>halbench::app::StartList</name>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>复制路径</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>从列表中移除</translation>
    </message>
</context>
<context>
    <name>halbench::app::SampleList</name>
    <message>
        <source>Sample recordings</source>
        <translation>示例记录</translation>
    </message>
    <message>
        <source>Enter or double-click opens a copy</source>
        <translation>按回车键或双击打开副本</translation>
    </message>
    <message>
        <source>Five-minute tour</source>
        <translation>五分钟导览</translation>
    </message>
    <message>
        <source>Shows the steps from connecting to tuning (Shift+F1)</source>
        <translation>演示从连接到整定的步骤（Shift+F1）</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Motor: step of 30°</source>
        <translation>电机：30° 阶跃</translation>
    </message>
    <message>
        <source>Positioner: step of 100 µm along x</source>
        <translation>定位台：沿 x 阶跃 100 µm</translation>
    </message>
    <message>
        <source>Sphere: turning, with its orientation</source>
        <translation>球体：转动及其姿态</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Connect a device</source>
        <translation>连接设备</translation>
    </message>
    <message>
        <source>Choose a simulated actuator and press Enter, or double-click it. A real device is listed when it is plugged in.</source>
        <translation>选择一个仿真执行器并按回车，或双击它。真实设备插入后会出现在列表中。</translation>
    </message>
    <message>
        <source>Watch the signals</source>
        <translation>观察信号</translation>
    </message>
    <message>
        <source>The plots follow the device. F6 lists all signals, Space pauses the view, the wheel zooms.</source>
        <translation>曲线图跟随设备。F6 列出所有信号，空格键暂停视图，滚轮缩放。</translation>
    </message>
    <message>
        <source>Arm and drive</source>
        <translation>使能并驱动</translation>
    </message>
    <message>
        <source>Arm, choose a reference, for example a sine, and start it. Esc or STOP stops the actuator at any time.</source>
        <translation>使能，选择参考值（例如正弦）并启动。Esc 或“停止”可随时停止执行器。</translation>
    </message>
    <message>
        <source>Calibrate the sensors</source>
        <translation>标定传感器</translation>
    </message>
    <message>
        <source>A short motion measures the errors of the sensors; Apply corrects them. Simulated time 20 times shortens the wait.</source>
        <translation>一段短暂的运动测出传感器误差；“应用”将其校正。仿真时间设为 20 倍可缩短等待。</translation>
    </message>
    <message>
        <source>Identify the actuator</source>
        <translation>辨识执行器</translation>
    </message>
    <message>
        <source>Start identification measures the constants of the model, each with its 95 % interval, or says why it cannot.</source>
        <translation>“开始辨识”测出模型的各个常数，每个都带有 95 % 区间；若无法得到则说明原因。</translation>
    </message>
    <message>
        <source>Tune the controller</source>
        <translation>整定控制器</translation>
    </message>
    <message>
        <source>Tune designs gains for the identified model. Apply and verify compares a test move with the prediction; Keep or Restore ends it.</source>
        <translation>“整定”为辨识出的模型设计增益。“应用并验证”将一次测试运动与预测作比较；最后选择“保留”或“恢复”。</translation>
    </message>
    <message>
        <source>Record and compare</source>
        <translation>记录并比较</translation>
    </message>
    <message>
        <source>Ctrl+R starts and ends a recording. The list of recordings opens, replays and overlays them.</source>
        <translation>Ctrl+R 开始和结束记录。在记录列表中可打开、回放和叠加记录。</translation>
    </message>
    <message>
        <source>Find help</source>
        <translation>查找帮助</translation>
    </message>
    <message>
        <source>F1 explains the panel with the focus, Ctrl+F1 lists all keys. First steps and this tour are in the Help menu.</source>
        <translation>F1 说明有焦点的面板，Ctrl+F1 列出所有按键。“入门”和本导览在“帮助”菜单中。</translation>
    </message>
</context>
<context>
    <name>halbench::app::Tour</name>
    <message>
        <source>Five-minute &amp;tour</source>
        <translation>五分钟导览(&amp;T)</translation>
    </message>
</context>
<context>
    <name>halbench::app::TourCard</name>
    <message>
        <source>Five-minute tour</source>
        <translation>五分钟导览</translation>
    </message>
    <message>
        <source>Shift+F1 switches between tour and panel.</source>
        <translation>Shift+F1 在导览与面板之间切换。</translation>
    </message>
    <message>
        <source>Leave the tour</source>
        <translation>退出导览</translation>
    </message>
    <message>
        <source>Leave the tour (Esc)</source>
        <translation>退出导览（Esc）</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>上一步（左方向键）</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>下一步（右方向键）</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
</context>
<context>
    <name>halbench::app::PathForm</name>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>圈数</translation>
    </message>
    <message>
        <source>Line length</source>
        <translation>行长</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Line spacing</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>停留时间</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>栅格</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Table of poses</source>
        <translation>位姿表</translation>
    </message>
    <message>
        <source>No file</source>
        <translation>无文件</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>CSV with columns like time_s, x_mm, phi_mrad</source>
        <translation>含 time_s、x_mm、phi_mrad 等列的 CSV</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>%1; 0: no limit</source>
        <translation>%1；0：无限值</translation>
    </message>
    <message>
        <source>No table of poses is chosen.</source>
        <translation>未选择位姿表。</translation>
    </message>
    <message>
        <source>Choose a CSV file.</source>
        <translation>请选择 CSV 文件。</translation>
    </message>
    <message>
        <source>Travel time: %1 s</source>
        <translation>行程时间：%1 s</translation>
    </message>
    <message>
        <source>Rotation speed</source>
        <translation>旋转速度</translation>
    </message>
    <message>
        <source>Rotation accel.</source>
        <translation>旋转加速度</translation>
    </message>
    <message>
        <source>Rotation jerk</source>
        <translation>旋转加加速度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>加加速度</translation>
    </message>
    <message>
        <source>File that the motion follows</source>
        <translation>运动所遵循的文件</translation>
    </message>
</context>
<context>
    <name>halbench::app::PathRun</name>
    <message>
        <source>Choose a table of poses</source>
        <translation>选择位姿表</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt)</source>
        <translation>表格 (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Moves together: %1.</source>
        <translation>同时移动：%1。</translation>
    </message>
    <message>
        <source>Above the limit: the device may stop.</source>
        <translation>超出限值：设备可能会停止。</translation>
    </message>
</context>
<context>
    <name>halbench::app::AngleErrorPanel</name>
    <message>
        <source>Time span</source>
        <translation>时间跨度</translation>
    </message>
    <message>
        <source>Length of the data shown, up to now</source>
        <translation>所示数据的长度，截至现在</translation>
    </message>
    <message>
        <source>Summary of the angle error</source>
        <translation>角度误差摘要</translation>
    </message>
    <message>
        <source>Shows the angle between the estimated and the true orientation of a simulated rotor. Connect a simulated device that measures its field, or play a recording with truth.alpha, truth.beta and truth.gamma.</source>
        <translation>显示仿真转子估计姿态与真实姿态之间的角度。请连接测量其磁场的仿真设备，或播放带有 truth.alpha、truth.beta 和 truth.gamma 的记录。</translation>
    </message>
    <message>
        <source>Angle between the estimated and the true orientation</source>
        <translation>估计姿态与真实姿态之间的角度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>angle error</source>
        <translation>角度误差</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>shaft</source>
        <translation>转轴</translation>
    </message>
    <message>
        <source>95 % cone of the shaft</source>
        <translation>转轴的 95 % 锥</translation>
    </message>
    <message>
        <source>%1 rows: %2° rms, %3° at most, to the nearest of the four orientations with the same field.</source>
        <translation>%1 行：有效值 %2°，最大 %3°，相对于同场的四个姿态中最近的一个。</translation>
    </message>
    <message>
        <source>Arrow keys read values; Ctrl+C copies, Ctrl+E saves</source>
        <translation>方向键读取数值；Ctrl+C 复制，Ctrl+E 保存</translation>
    </message>
</context>
</TS>
