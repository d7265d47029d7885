/* For each shot file, its events and its hash: played alone, by a simulator, and after writing and reading
 * the file and the trace. */
#include <carom.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char text[1 << 22];

static void fail(const char *path, const char *what)
{
    fprintf(stderr, "%s: %s\n", path, what);
    exit(1);
}

static void check_state(const char *path, const carom_shot *shot, const carom_trace *trace)
{
    int32_t balls = carom_shot_ball_count(shot);
    carom_state *all = malloc((size_t)balls * sizeof *all), one;
    double time = 0.37 * carom_trace_duration(trace);
    if (!all || carom_trace_states(trace, time, all, balls) != 0) {
        fail(path, "no states");
    }
    for (int32_t ball = 0; ball < balls; ++ball) {
        memset(&one, 0, sizeof one);
        const double *q = all[ball].orientation;
        double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        if (carom_trace_state(trace, ball, time, &one) != 0 ||
            memcmp(one.position, all[ball].position, 13 * sizeof(double)) != 0 ||
            one.motion != all[ball].motion || !(norm > 1.0 - 1e-12 && norm < 1.0 + 1e-12)) {
            fail(path, "the state of one ball differs from that of all");
        }
    }
    free(all);
}

int main(int argc, char **argv)
{
    char error[512];
    carom_sim *sim = carom_sim_new();
    for (int i = 1; i < argc; ++i) {
        FILE *file = fopen(argv[i], "rb");
        if (!file) {
            fail(argv[i], "cannot be read");
        }
        text[fread(text, 1, sizeof text - 1, file)] = '\0';
        fclose(file);
        carom_shot *shot = carom_shot_from_json(text, error, sizeof error);
        carom_trace *trace = carom_shot_simulate(shot, error, sizeof error);
        if (!trace) {
            fail(argv[i], error);
        }
        const carom_trace *played = carom_sim_play(sim, shot, error, sizeof error);
        carom_events events, again;
        if (carom_trace_events(trace, &events) != carom_trace_events(played, &again) ||
            carom_trace_hash(trace) != carom_trace_hash(played)) {
            fail(argv[i], "a simulator plays another shot");
        }
        char *json = carom_shot_to_json(shot), *trace_json = carom_trace_to_json(trace);
        carom_shot *reread = carom_shot_from_json(json, error, sizeof error);
        carom_trace *second = carom_shot_simulate(reread, error, sizeof error);
        carom_trace *saved = carom_trace_from_json(trace_json, error, sizeof error);
        if (!second || !saved || carom_trace_hash(second) != carom_trace_hash(trace) ||
            carom_trace_hash(saved) != carom_trace_hash(trace)) {
            fail(argv[i], "a written file has other bits");
        }
        check_state(argv[i], shot, trace);
        printf("%d %016llx %a\n", events.event_count, (unsigned long long)carom_trace_hash(trace),
               carom_trace_duration(trace));
        carom_text_free(json);
        carom_text_free(trace_json);
        carom_trace_free(saved);
        carom_trace_free(second);
        carom_shot_free(reread);
        carom_trace_free(trace);
        carom_shot_free(shot);
    }
    carom_sim_free(sim);
    return 0;
}
