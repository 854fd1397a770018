/* Constant texts that live for ever, which are C's to give: the version, and what the codes of kyvadlo.h mean. */
#include "kyvadlo.h"

const char *kyvadlo_version(void)
{
   return KYVADLO_VERSION;
}

const char *kyvadlo_message(int code)
{
   switch (code) {
   case KYVADLO_OK: return "no error";
   case KYVADLO_DOMAIN: return "the values break a rule of the motion";
   default: return "unknown code";
   }
}
