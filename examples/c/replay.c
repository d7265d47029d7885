/* Replays a file: simulates the shot of a saved trace again, and compares every bit by the hash.
 *
 *     replay TRACE.json         such as: carom shot shots/masse.json --json > masse.json
 */
#include <carom.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    static char text[1 << 24]; /* 16 MB, more than any trace has */
    char error[512];
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    if (!file) {
        fprintf(stderr, "usage: replay TRACE.json\n");
        return 2;
    }
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    carom_trace *saved = carom_trace_from_json(text, error, sizeof error);
    if (!saved) {
        fprintf(stderr, "%s: %s\n", argv[1], error);
        return 2;
    }
    carom_shot *shot = carom_trace_shot(saved);
    carom_trace *again = carom_shot_simulate(shot, error, sizeof error);
    if (!again) {
        fprintf(stderr, "%s\n", error);
        return 1;
    }
    int same = carom_trace_hash(saved) == carom_trace_hash(again);
    printf("%s: %s, %.3f s, hash %016llx\n", argv[1], same ? "the same bits" : "OTHER BITS",
           carom_trace_duration(again), (unsigned long long)carom_trace_hash(again));
    carom_trace_free(again);
    carom_shot_free(shot);
    carom_trace_free(saved);
    return same ? 0 : 1;
}
