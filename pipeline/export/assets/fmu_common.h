/* Functions of FMI 2.0 that every FMU of debist has alike. FMU_GUID, Instance with its Data d, its tools and its name, and
 * blank(Data *) are known where this is included. */

static fmi2Status tell(const Instance *m, fmi2Status status, const char *message)
{
    if (m->tools.logger) {
        m->tools.logger(m->tools.componentEnvironment, m->name, status, "logStatusError", "%s", message);
    }
    return status;
}

FMI2_Export const char *fmi2GetTypesPlatform(void) { return "default"; }
FMI2_Export const char *fmi2GetVersion(void) { return "2.0"; }

FMI2_Export void fmi2FreeInstance(fmi2Component c)
{
    if (c) ((Instance *)c)->tools.freeMemory(c);
}

FMI2_Export fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                          const fmi2CallbackFunctions *tools, fmi2Boolean visible, fmi2Boolean logging)
{
    Instance *m;
    (void)type, (void)resources, (void)visible, (void)logging;
    if (!tools || !tools->allocateMemory || !tools->freeMemory || !guid || strcmp(guid, FMU_GUID)) return NULL;
    m = tools->allocateMemory(1, sizeof *m);
    if (!m) return NULL;
    m->tools = *tools;
    m->name[0] = 0;
    strncat(m->name, name ? name : "", sizeof m->name - 1);
    blank(&m->d);
    return m;
}

FMI2_Export fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[])
{
    (void)c, (void)on, (void)n, (void)categories;
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance,
                                           fmi2Real start, fmi2Boolean has_stop, fmi2Real stop)
{
    (void)c, (void)has_tolerance, (void)tolerance, (void)start, (void)has_stop, (void)stop;
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2EnterInitializationMode(fmi2Component c) { (void)c; return fmi2OK; }

FMI2_Export fmi2Status fmi2Terminate(fmi2Component c) { (void)c; return fmi2OK; }

static fmi2Status none(fmi2Component c, size_t n)
{
    return n ? tell(c, fmi2Error, "the model has no such variable to get or set") : fmi2OK;
}

FMI2_Export fmi2Status fmi2SetInteger(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Integer value[])
{
    (void)vr, (void)value;
    return none(c, n);
}

FMI2_Export fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Boolean value[])
{
    (void)vr, (void)value;
    return none(c, n);
}

FMI2_Export fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Boolean value[])
{
    (void)vr, (void)value;
    return none(c, n);
}

FMI2_Export fmi2Status fmi2GetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2String value[])
{
    (void)vr, (void)value;
    return none(c, n);
}

FMI2_Export fmi2Status fmi2SetString(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2String value[])
{
    (void)vr, (void)value;
    return none(c, n);
}

FMI2_Export fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *kept)
{
    Instance *m = c;
    if (!*kept) *kept = m->tools.allocateMemory(1, sizeof(Data));
    if (!*kept) return tell(m, fmi2Error, "no memory for a state");
    memcpy(*kept, &m->d, sizeof(Data));
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate kept)
{
    memcpy(&((Instance *)c)->d, kept, sizeof(Data));
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *kept)
{
    if (*kept) ((Instance *)c)->tools.freeMemory(*kept);
    *kept = NULL;
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate kept, size_t *size)
{
    (void)c, (void)kept;
    *size = sizeof(Data);
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate kept, fmi2Byte bytes[], size_t size)
{
    if (size < sizeof(Data)) return tell(c, fmi2Error, "too few bytes for a state");
    memcpy(bytes, kept, sizeof(Data));
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *kept)
{
    Instance *m = c;
    if (size != sizeof(Data)) return tell(m, fmi2Error, "these bytes are no state of this model");
    if (!*kept) *kept = m->tools.allocateMemory(1, sizeof(Data));
    if (!*kept) return tell(m, fmi2Error, "no memory for a state");
    memcpy(*kept, bytes, sizeof(Data));
    return fmi2OK;
}

FMI2_Export fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t n_unknown,
                                                    const fmi2ValueReference known[], size_t n_known,
                                                    const fmi2Real change[], fmi2Real response[])
{
    (void)unknown, (void)n_unknown, (void)known, (void)n_known, (void)change, (void)response;
    return tell(c, fmi2Error, "directional derivatives are not provided");
}

FMI2_Export fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                                    const fmi2Integer order[], fmi2Real value[])
{
    (void)vr, (void)order, (void)value;
    return none(c, n);
}

FMI2_Export fmi2Status fmi2CancelStep(fmi2Component c) { return tell(c, fmi2Error, "steps are not asynchronous"); }

FMI2_Export fmi2Status fmi2GetStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Status *value)
{
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

FMI2_Export fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Real *value)
{
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

FMI2_Export fmi2Status fmi2GetIntegerStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Integer *value)
{
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

FMI2_Export fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean *value)
{
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

FMI2_Export fmi2Status fmi2GetStringStatus(fmi2Component c, const fmi2StatusKind kind, fmi2String *value)
{
    (void)c, (void)kind, (void)value;
    return fmi2Discard;
}

FMI2_Export fmi2Status fmi2Reset(fmi2Component c)
{
    blank(&((Instance *)c)->d);
    return fmi2OK;
}
