/* A mass on a spring with a damper, for FMI 2.0: what tests make FMUs of. WRONG is what a call does instead. */
#include <stdlib.h>
#include <string.h>
#define EXPORT __attribute__((visibility("default")))
typedef struct { double time, x, v, force, m, d, k; int count; } Mass;
static double *place(Mass *c, unsigned reference) {
    double *all[] = {&c->time, &c->x, &c->v, &c->force, &c->m, &c->d, &c->k};
    return reference < 7 ? all[reference] : 0;
}
EXPORT void *fmi2Instantiate(const char *name, int kind, const char *token, const char *uri, const void *call, int v, int l) {
    Mass *c = calloc(1, sizeof(Mass));
    if (strcmp(token, "{mass}")) return 0;
    c->m = 2; c->d = 0.5; c->k = 8; c->x = 0.1;
    return c;
}
EXPORT void fmi2FreeInstance(void *c) { free(c); }
EXPORT int fmi2SetupExperiment(void *c, int a, double b, double start, int d, double stop) { ((Mass *)c)->time = start; return 0; }
EXPORT int fmi2EnterInitializationMode(void *c) { return 0; }
EXPORT int fmi2ExitInitializationMode(void *c) { return 0; }
EXPORT int fmi2Reset(void *c) { return 0; }
static double rate(Mass *c) { return (c->force - c->d * c->v - c->k * c->x) / c->m; }
EXPORT int fmi2GetReal(void *c, const unsigned *r, size_t n, double *v) {
    for (size_t i = 0; i < n; i++) {
        if (r[i] == 7) v[i] = ((Mass *)c)->v;
        else if (r[i] == 8) v[i] = rate(c);
        else if (!place(c, r[i])) return 3;
        else v[i] = *place(c, r[i]);
    }
    return 0;
}
EXPORT int fmi2SetReal(void *c, const unsigned *r, size_t n, const double *v) {
    for (size_t i = 0; i < n; i++) { if (!place(c, r[i])) return 3; *place(c, r[i]) = v[i]; }
    return 0;
}
EXPORT int fmi2EnterEventMode(void *c) { return 0; }
EXPORT int fmi2NewDiscreteStates(void *c, void *info) { memset(info, 0, 5 * sizeof(int)); return 0; }
EXPORT int fmi2EnterContinuousTimeMode(void *c) { return 0; }
EXPORT int fmi2CompletedIntegratorStep(void *c, int a, int *b, int *d) { *b = *d = 0; return 0; }
EXPORT int fmi2SetTime(void *c, double t) { ((Mass *)c)->time = t; return 0; }
EXPORT int fmi2SetContinuousStates(void *c, const double *x, size_t n) { ((Mass *)c)->x = x[0]; ((Mass *)c)->v = x[1]; return 0; }
EXPORT int fmi2GetContinuousStates(void *c, double *x, size_t n) { x[0] = ((Mass *)c)->x; x[1] = ((Mass *)c)->v; return 0; }
EXPORT int fmi2GetDerivatives(void *c, double *x, size_t n) {
    if (++((Mass *)c)->count > 300) { WRONG; }
    x[0] = ((Mass *)c)->v; x[1] = rate(c);
    return 0;
}
EXPORT int fmi2GetEventIndicators(void *c, double *x, size_t n) { return 0; }
EXPORT int fmi2DoStep(void *p, double t, double h, int a) {
    Mass *c = p;
    if (++c->count > 300) { WRONG; }
    for (int i = 0; i < 100; i++) {          /* midpoint steps */
        double v = c->v, x = c->x, s = h / 100, w = rate(c);
        c->x = x + s / 2 * v; c->v = v + s / 2 * w;
        w = rate(c);
        c->x = x + s * c->v; c->v = v + s * w;
    }
    return 0;
}
