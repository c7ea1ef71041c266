% What Octave's control package takes for the work of octave_bench.cpp, in one process, and its results:
% seconds of a call of margins, step, discretisation and simulation, then the numbers to compare.
pkg load control

function seconds = least_s(work, calls)
  seconds = Inf;
  for round = 1:5
    before = cputime();
    for i = 1:calls
      value = work();
    endfor
    seconds = min(seconds, (cputime() - before) / calls);
  endfor
endfunction

% The sampled loop of the published motor with the recommended gains, built from its numbers so that both
% sides judge the same fractions.
T = 0.01;
a = 1.23e-3 / 5.5e-4;
k = 26;
E = exp(-a * T);
b1 = k / a^2 * (a * T - 1 + E);
b2 = k / a^2 * (1 - E - a * T * E);
plant = tf([b1, b2], conv([1, -1], [1, -E]), T);
KP = 40; KI = 60; KD = 1.4;
law = tf([KP + KD / T, T * KI - KP - 2 * KD / T, KD / T], [1, -1, 0], T);
loop = plant * law;
closed = feedback(loop, 1);

% 1.2e6 (s+30)/((s+1)(s+5)(s^2+4s+400)(s^2+36s+3600))
sixth = tf([1.2e6, 3.6e7], conv(conv([1, 6, 5], [1, 4, 400]), [1, 36, 3600]));
sampled = c2d(sixth, 0.01, "zoh");

input = sin(0.001 * (0:9999)' .^ 1.2);
time = T * (0:9999)';

margin_s = least_s(@() margin(loop), 50);
step_s = least_s(@() step(sixth, 0:0.01:6), 20);
discretise_s = least_s(@() c2d(sixth, 0.01, "zoh"), 50);
simulate_s = least_s(@() lsim(sampled, input, time), 3);

[response, at] = step(sixth, 0:0.01:6);
[num, den] = tfdata(sampled, "vector");
output = lsim(sampled, input, time);
[g, p, wg, wp] = margin(loop);

printf("%.17g %.17g %.17g %.17g\n", margin_s, step_s, discretise_s, simulate_s);
printf("%.17g %.17g %.17g %.17g\n", g, p, wg, wp);
printf("%.17g ", response(51), response(201), response(601), den(2), den(7), num(end), output(2001), output(10000));
printf("\n");
